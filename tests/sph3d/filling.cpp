#include "filling.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ostium::sph3d {

void DensityErrors::add(double error) {
  ++count, sum += error, squares += error * error;
  if (std::abs(error) > std::abs(largest)) largest = error;
}

double DensityErrors::rms() const { return count ? std::sqrt(squares / static_cast<double>(count)) : 0; }

namespace {

constexpr double layer_ends[] = {0.75, 1.5, 2.6, 5.0, 1e9};  // from the wall, in spacings
constexpr double depth_ends[] = {2.6, 6.0, 12.0};            // behind a cap, in spacings
constexpr double branch_length = 4;                          // in widths of the opening

/// The branch behind an opening: the opening whose centre is nearest, within some of its widths.
int branch_of(const Lumen<3>& lumen, const std::vector<double>& widths, const Vec3& x) {
  int best = -1;
  double nearest = branch_length;
  for (std::size_t k = 0; k < lumen.openings.size(); ++k)
    if (const double r = (x - lumen.openings[k].centre).norm() / widths[k]; r < nearest)
      nearest = r, best = static_cast<int>(k);
  return best;
}

template <std::size_t N>
std::size_t bin(const double (&ends)[N], double x) {
  std::size_t b = 0;
  while (b < N && x >= ends[b]) ++b;
  return b;
}

struct Parts {
  explicit Parts(const Lumen<3>& lumen) {
    double from = 0;
    for (const double to : layer_ends) {
      layers.push_back({to > 1e6 ? fmt::format("deeper than {} dp", from)
                                 : fmt::format("{} to {} dp from the wall", from, to)});
      from = to;
    }
    for (const auto& o : lumen.openings) branches.push_back({"branch of " + o.name});
    branches.push_back({"trunk"});
    from = 0;
    for (const double to : depth_ends) {
      depths.push_back({fmt::format("{} to {} dp behind a cap", from, to)});
      from = to;
    }
  }
  std::vector<DensityErrors> layers, branches, depths;
};

}  // namespace

Filling measure_filling(const Vessel<3>& vessel) {
  const auto& model = vessel.model();
  const auto& fluid = vessel.state().fluid;
  const auto& work = vessel.workspace();
  const double dp = model.options.dp;
  const SignedDistance<3> domain(model.domain.surface), lumen(model.lumen.surface);
  std::vector<double> widths;
  for (const auto& o : model.lumen.openings) widths.push_back(width(o));
  Parts parts(model.lumen);
  Filling filling{.particles = fluid.count(), .expected = model.domain.volume / model.particle_volume};
  filling.outermost = -1e9;
  for (std::size_t i = 0; i < fluid.places(); ++i) {
    if (!fluid.filled[i]) continue;
    const Vec3& x = fluid.position[i];
    const double phi = domain(x).phi / dp;
    filling.outside += phi > 0;
    filling.outermost = std::max(filling.outermost, phi);
    if (work.duct_of[i] >= 0) continue;
    const double sum = work.sums[i / 8].density[i % 8] + work.around[i / 8].filling[i % 8];
    const double error = sum / model.number_density - 1 - fluid.psi(i);
    const int branch = branch_of(model.lumen, widths, x);
    const double depth = branch < 0 ? 1e9 : model.ducts[branch].depth(x) / dp - Duct<3>::layers;
    if (std::abs(error) > std::abs(filling.all.largest)) {
      filling.worst = x;
      filling.worst_place = fmt::format("{:.2f} dp from the wall, {}", -phi,
                                        branch < 0 ? "trunk"
                                                   : fmt::format("{:.1f} dp behind the cap of {}", depth,
                                                                 model.lumen.openings[branch].name));
    }
    filling.all.add(error);
    parts.layers[bin(layer_ends, -phi)].add(error);
    parts.branches[branch < 0 ? parts.branches.size() - 1 : branch].add(error);
    if (const auto b = bin(depth_ends, depth); b < std::size(depth_ends)) parts.depths[b].add(error);
  }
  for (auto* group : {&parts.layers, &parts.branches, &parts.depths})
    filling.parts.insert(filling.parts.end(), group->begin(), group->end());
  return filling;
}

std::string table(const Filling& f) {
  const auto line = [](const DensityErrors& e) {
    return fmt::format("  {:<28} {:>7} particles   rms {:6.3f} %   mean {:+6.3f} %   largest {:+6.2f} %\n",
                       e.part, e.count, 100 * e.rms(), 100 * e.mean(), 100 * e.largest);
  };
  std::string text =
      fmt::format("{} particles, {:.1f} expected ({:+.3f} %), outside {}, outermost {:.3f} dp\n", f.particles,
                  f.expected, 100 * (double(f.particles) / f.expected - 1), f.outside, f.outermost);
  DensityErrors all = f.all;
  all.part = "vessel without its ducts";
  text += line(all);
  for (const auto& part : f.parts) text += line(part);
  return text + fmt::format("  largest error at ({:.3f}, {:.3f}, {:.3f}) mm: {}\n", 1e3 * f.worst[0],
                            1e3 * f.worst[1], 1e3 * f.worst[2], f.worst_place);
}

}  // namespace ostium::sph3d
