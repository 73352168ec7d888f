#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/baseline.hpp"
#include "bench/work_counts.hpp"

namespace ostium::bench {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Timing& t) { return {{"median_ns", 1e9 * t.median}, {"best_ns", 1e9 * t.best}}; }

Json json_of(const MachineResult& m) {
  return {{"multiply_add_flop_per_second", m.multiply_add},
          {"vectors", m.vectors},
          {"triad_bytes_per_second", m.triad},
          {"load_average", m.load},
          {"cores", m.cores}};
}

Json json_of(const WallResult& w) {
  Json rows;
  for (const auto& row : w.rows)
    rows.push_back({{"what", row.what}, {"near", json_of(row.near)}, {"inner", json_of(row.inner)}});
  Json layers;
  for (const auto& row : w.layers)
    layers.push_back({{"spacing_over_dp", row.spacing},
                      {"shell_particles_per_cluster", row.row_length},
                      {"rows", json_of(row.rows)},
                      {"sums", json_of(row.sums)},
                      {"each_acoustic_step", json_of(row.impact)}});
  return {{"share_of_clusters", w.near_share},
          {"near_over_inner", w.ratio},
          {"rows", rows},
          {"virtual_layers", layers}};
}

Json json_of(const StepResult& s, const MachineResult& m) {
  Json parts;
  for (const auto& part : s.parts)
    parts.push_back({{"name", part.name}, {"each_time", json_of(part.time)}, {"share_of_steps", part.share}});
  const double flop = flop_per_particle(s.row_length), bytes = bytes_per_particle(s.row_length);
  return {{"particles", s.particles},
          {"row_length", s.row_length},
          {"kick", json_of(s.kick)},
          {"density", json_of(s.density)},
          {"drive_ports", json_of(s.driving)},
          {"acoustic_step_ns", 1e9 * s.acoustic()},
          {"particle_steps_per_second_per_core", 1 / s.acoustic()},
          {"flop_per_particle_step", flop},
          {"bytes_per_particle_step", bytes},
          {"share_of_multiply_add_peak", flop / s.acoustic() / m.multiply_add},
          {"share_of_triad", bytes / s.acoustic() / m.triad},
          {"advection_parts", parts},
          {"acoustic_step_in_run", json_of(s.acoustic_in_run)},
          {"advection_step_in_run", json_of(s.advection_in_run)},
          {"advection_over_acoustic", s.advection_over_acoustic},
          {"acoustic_steps_per_advection_step", s.acoustic_per_advection},
          {"peak_resident_bytes", s.resident},
          {"peak_resident_bytes_before_vessel", s.resident_before},
          {"peak_resident_bytes_per_particle", s.resident / static_cast<double>(s.particles)},
          {"walls", json_of(s.walls)}};
}

Json json_of(const KernelResult& r) {
  Json rows;
  for (const auto& row : r.rows)
    rows.push_back({{"what", row.what},
                    {"kernels", row.who},
                    {"per_particle", json_of(row.per_particle)},
                    {"times_faster_than_plain", row.times_faster}});
  return {{"particles", r.particles}, {"rows", rows}};
}

Json json_of(const EngineResult& r) {
  Json rows;
  for (const auto& row : r.rows)
    rows.push_back(
        {{"threads", row.threads},
         {"median_particle_steps_per_second_per_core", 1 / row.per_particle_step.median / row.threads},
         {"best_particle_steps_per_second_per_core", 1 / row.per_particle_step.best / row.threads},
         {"preparation_share", row.preparation}});
  return {{"vessel", r.vessel},
          {"particles", r.particles},
          {"acoustic_steps_per_advection_step", r.acoustic_per_advection},
          {"rows", rows}};
}

}  // namespace

void write_json(const Results& r, const std::filesystem::path& file) {
  Json json{{"machine", json_of(r.machine)},
            {"step", json_of(r.step, r.machine)},
            {"kernels", json_of(r.kernels)},
            {"engine", json_of(r.engine)}};
  for (const auto& ratio : ratios_of(r).all) json["ratios"][ratio.name] = ratio.value;
  std::ofstream out(file);
  out << json.dump(2) << "\n";
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace ostium::bench
