#include "app/check.hpp"

#include <cmath>

#include "app/calibrate_case.hpp"
#include "app/estimate.hpp"
#include "app/results/sensitivity_output.hpp"
#include "app/sweep/plan.hpp"
#include "core/log.hpp"
#include "lumped/block.hpp"
#include "sph3d/geometry/read.hpp"

namespace ostium::app {
namespace {

std::string openings_of(const sph3d::Lumen<3>& lumen) { return sph3d::describe(lumen); }

std::string openings_of(const sph3d::Lumen<2>& lumen) {
  std::string text =
      fmt::format("lumen {:.4g} cm2, wall {:.4g} cm\n", 1e4 * lumen.volume, 1e2 * lumen.wall_area);
  for (const auto& o : lumen.openings)
    text += fmt::format("  {:<12} {:>8.4g} mm wide at ({:.4g}, {:.4g}) mm\n", o.name, 1e3 * o.area,
                        1e3 * o.centre.x(), 1e3 * o.centre.y());
  return text;
}

template <int D>
std::string vessel_part(const Case& study, int threads) {
  const Setup<D> s = set_up<D>(study);
  std::string text = openings_of(s.lumen);
  if (!text.ends_with('\n')) text += '\n';
  for (std::size_t k = 0; k < s.ports.size(); ++k)
    text += fmt::format("  {:<12} {}\n", s.ports[k].opening,
                        s.kinds[k] == network::PortKind::flow
                            ? fmt::format("flow prescribed by the network, {} profile",
                                          s.profiles[k] == sph3d::Profile::plug ? "plug" : "parabolic")
                            : "pressure of the network");
  if (s.wall)
    text += fmt::format("  wall       a {} of {} particles\n", is_solid(*s.wall) ? "solid" : "shell",
                        particles_of(*s.wall));
  for (const auto& probe : s.probes) text += fmt::format("  {:<12} probe {}\n", probe.name, place_of(probe));
  const Estimate e = estimate(study, s, nominal_speed(threads));
  for (const auto& line : estimate_lines(study, e, threads)) text += line + "\n";
  return text;
}

std::string network_part(const Case& study) {
  const network::Model model = network::read_model(study.network.blocks);
  if (study.sweep) sweep_plan(study);
  check_calibration(study, model);
  if (!study.vessel) sought(study, model, network::Network{model}.series_names());
  std::string text = fmt::format("network   {} blocks, starts {}\n", model.entries.size(),
                                 study.initial() == network::Initial::periodic ? "periodic" : "at rest");
  for (const auto& line : network_lines(model)) text += fmt::format("  {}\n", line);
  return text;
}

}  // namespace

std::vector<std::string> network_lines(const network::Model& model) {
  std::vector<std::string> lines;
  for (const auto& entry : model.entries) {
    std::string ends;
    for (const auto& t : entry.block->terminals())
      ends +=
          fmt::format(" {} {}", t.key, t.grounded() ? fmt::format("ground ({:.4g} Pa)", t.ground) : t.node);
    lines.push_back(fmt::format("{:<12} {:<16}{}", entry.name, entry.block->type(), ends));
  }
  return lines;
}

std::vector<std::string> estimate_lines(const Case& study, const Estimate& e, int threads) {
  return {fmt::format("particles about {} at {:.4g} mm, memory about {:.2g} GB", count_text(e.particles),
                      1e3 * study.vessel->spacing, e.memory / 1e9),
          fmt::format("run time  roughly {} on {} cores of ordinary speed ({} acoustic steps)",
                      duration_text(e.wall), threads, count_text(e.steps))};
}

std::string check(const Case& study, int threads) {
  std::string text = study.title.empty() ? "" : study.title + "\n";
  text += network_part(study);
  if (study.vessel)
    text += study.vessel->dimension == 2 ? vessel_part<2>(study, threads) : vessel_part<3>(study, threads);
  const double end = study.time.final();
  text += study.time.period ? fmt::format("time      {:.4g} s, {:.4g} periods of {:.4g} s\n", end,
                                          end / *study.time.period, *study.time.period)
                            : fmt::format("time      {:.4g} s\n", end);
  const auto warnings = log::warnings().size();
  return text + (warnings ? fmt::format("in order, with {} warning{}\n", warnings, warnings == 1 ? "" : "s")
                          : "in order\n");
}

}  // namespace ostium::app
