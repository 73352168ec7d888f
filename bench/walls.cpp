#include <memory>
#include <stdexcept>

#include "bench/layer_rows.hpp"
#include "bench/workload.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

/// Some clusters as a fluid of their own, for what does not look at neighbours.
struct Extract {
  FluidState<3> fluid;
  Workspace<3> work;

  void add(const Prepared& from, std::size_t c) {
    for (std::size_t i = 8 * c; i < 8 * c + 8; ++i) {
      fluid.position.push_back(from.fluid.position[i]);
      fluid.filled.push_back(from.fluid.filled[i]);
      work.duct_of.push_back(from.work.duct_of[i]);
    }
    fluid.clusters.push_back(from.fluid.clusters[c]);
  }
};

/// Which clusters, as stretches of memory and on their own.
struct Group {
  std::vector<std::pair<std::int64_t, std::int64_t>> stretches;
  Extract extract;
  std::size_t clusters = 0;

  void add(const Prepared& from, std::int64_t c) {
    if (!stretches.empty() && stretches.back().second == c)
      ++stretches.back().second;
    else
      stretches.emplace_back(c, c + 1);
    extract.add(from, static_cast<std::size_t>(c));
    ++clusters;
  }
};

bool near_wall(const ClusterSurroundings<3>& around) {
  for (const float filling : around.filling)
    if (filling > 0.0f) return true;
  return false;
}

constexpr double shell_spacings[] = {1.0, 0.5};  // over dp

/// Layers on the same clusters, in turn with the look-up of the field they replace.
std::vector<WallResult::LayerRow> measure_layers(const Prepared& p, const std::vector<std::size_t>& near,
                                                 std::function<void()> look_up, int rounds) {
  std::vector<std::unique_ptr<LayerRows>> layers;
  std::vector<std::function<void()>> rivals{std::move(look_up)};
  for (const double spacing : shell_spacings) {
    LayerRows& rows =
        *layers.emplace_back(std::make_unique<LayerRows>(p, near, spacing * p.model.options.dp));
    rivals.insert(rivals.end(), {[&] { rows.find(); }, [&] { rows.sums(); }, [&] { rows.impact(); }});
  }
  const auto times = in_turn(rivals, rounds);
  const auto per = [&](const Timing& t) {
    return Timing{t.median / (8.0 * double(near.size())), t.best / (8.0 * double(near.size()))};
  };
  std::vector<WallResult::LayerRow> result;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (layers[k]->error() > 1e-3) throw std::runtime_error("virtual layers in lanes: sums are wrong");
    result.push_back({.spacing = shell_spacings[k],
                      .row_length = layers[k]->mean_length(),
                      .rows = per(times[3 * k + 1]),
                      .sums = per(times[3 * k + 2]),
                      .impact = per(times[3 * k + 3])});
  }
  return result;
}

using Kernel = void (Prepared::*)(const FluidKernels<3>&, std::int64_t, std::int64_t);

}  // namespace

WallResult measure_walls(const Vessel<3>& tube, double acoustic_per_advection, int rounds) {
  Prepared p(tube);
  Group near, inner;
  std::vector<std::size_t> near_clusters;
  for (std::int64_t c = 0; c < p.clusters(); ++c) {
    const bool is_near = near_wall(p.work.around[c]);
    (is_near ? near : inner).add(p, c);
    if (is_near) near_clusters.push_back(c);
  }
  for (Group* part : {&near, &inner}) freeze(p.model, part->extract.fluid, part->extract.work);
  const auto over = [&](Group& part, Kernel kernel) {
    return [&p, &part, kernel] {
      for (const auto& [begin, end] : part.stretches) (p.*kernel)(fluid_kernels<3>(), begin, end);
    };
  };
  const auto look = [&](Group& part) {
    return [&p, &part] { look_around(p.model, part.extract.fluid, part.extract.work); };
  };
  const std::vector<std::pair<std::string, Kernel>> kernels{{"kernel sums", &Prepared::sums},
                                                            {"corrections", &Prepared::corrections},
                                                            {"corrected sums", &Prepared::corrected_sums},
                                                            {"kick", &Prepared::kick},
                                                            {"density", &Prepared::density}};
  std::vector<std::function<void()>> rivals{look(near), look(inner)};
  for (const auto& [name, kernel] : kernels)
    rivals.insert(rivals.end(), {over(near, kernel), over(inner, kernel)});
  const auto times = in_turn(rivals, rounds);
  WallResult result{.near_share = double(near.clusters) / double(p.clusters())};
  double sum[2] = {0, 0};
  for (std::size_t k = 0; k < times.size() / 2; ++k) {
    const std::string name = k == 0 ? "look around" : kernels[k - 1].first;
    const double weight = name == "kick" || name == "density" ? acoustic_per_advection : 1.0;
    const auto per = [](const Timing& t, std::size_t clusters) {
      return Timing{t.median / (8.0 * double(clusters)), t.best / (8.0 * double(clusters))};
    };
    result.rows.push_back({name, per(times[2 * k], near.clusters), per(times[2 * k + 1], inner.clusters)});
    sum[0] += weight * result.rows.back().near.median;
    sum[1] += weight * result.rows.back().inner.median;
  }
  result.ratio = sum[0] / sum[1];
  result.layers = measure_layers(p, near_clusters, look(near), rounds);
  return result;
}

}  // namespace ostium::bench
