#include <fmt/format.h>

#include "bench/bench.hpp"
#include "bench/work_counts.hpp"

namespace ostium::bench {

namespace {

double ns(double seconds) { return 1e9 * seconds; }

}  // namespace

void print(const MachineResult& m) {
  fmt::print(
      "Machine, one core: {:.1f} Gflop/s multiply-add in single precision ({}), {:.1f} GB/s triad; load "
      "average {:.1f} on {} cores\n",
      1e-9 * m.multiply_add, m.vectors, 1e-9 * m.triad, m.load, m.cores);
}

namespace {

void print_acoustic(const StepResult& s, const MachineResult& m) {
  const double flop = flop_per_particle(s.row_length), bytes = bytes_per_particle(s.row_length);
  const double rate = 1 / s.acoustic();
  fmt::print("{:<28} {:9.1f} {:9.1f}\n", "acoustic step: kick", ns(s.kick.median), ns(s.kick.best));
  fmt::print("{:<28} {:9.1f} {:9.1f}\n", "               density", ns(s.density.median), ns(s.density.best));
  fmt::print("{:<28} {:9.1f} {:9.1f}\n", "               drive ports", ns(s.driving.median),
             ns(s.driving.best));
  fmt::print("{:<28} {:9.1f} {:9.1f}   {:.2f} Mps/s per core\n", "               together", ns(s.acoustic()),
             ns(s.kick.best + s.driving.best + s.density.best), 1e-6 * rate);
  fmt::print(
      "  {:.0f} flop and {:.0f} bytes per particle-step (counted): {:.1f} Gflop/s, {:.0f} % of peak; {:.2f} "
      "GB/s, "
      "{:.0f} % of triad\n",
      flop, bytes, 1e-9 * flop * rate, 100 * flop * rate / m.multiply_add, 1e-9 * bytes * rate,
      100 * bytes * rate / m.triad);
}

void print_advection(const StepResult& s) {
  for (const auto& part : s.parts)
    fmt::print("{:<28} {:9.1f} {:9.1f}{}\n", "advection step: " + part.name, ns(part.mean()),
               ns(part.share * part.time.best),
               part.share < 1
                   ? fmt::format("   {:.0f} every {:.0f} steps", ns(part.time.median), 1 / part.share)
                   : "");
  fmt::print("{:<28} {:9.1f} {:9.1f}\n", "in a run: acoustic step", ns(s.acoustic_in_run.median),
             ns(s.acoustic_in_run.best));
  fmt::print("{:<28} {:9.1f} {:9.1f}   {:.2f} acoustic steps; there are {:.1f} of them in one\n",
             "          advection step", ns(s.advection_in_run.median), ns(s.advection_in_run.best),
             s.advection_over_acoustic, s.acoustic_per_advection);
  const double whole = s.advection_in_run.median + s.acoustic_per_advection * s.acoustic_in_run.median;
  fmt::print("{:<28} {:9.1f} {:9.1f}   {:.1f} % of a step, where fields are written\n",
             "          wall fields", ns(s.wall_fields.median), ns(s.wall_fields.best),
             100 * s.wall_fields.median / whole);
}

void print(const WallResult& w) {
  fmt::print("\nWalls: {:.0f} % of the clusters feel one\n", 100 * w.near_share);
  fmt::print("{:<28} {:>9} {:>9}\n", "ns per particle, median", "near", "inner");
  for (const auto& row : w.rows)
    fmt::print("{:<28} {:9.1f} {:9.1f}\n", row.what, ns(row.near.median), ns(row.inner.median));
  for (const auto& row : w.layers)
    fmt::print(
        "layers at dp/{:g} instead of the field: rows {:.1f}, sums {:.1f} (look around {:.1f}), each "
        "acoustic step {:.1f} "
        "more; {:.0f} shell particles per cluster\n",
        1 / row.spacing, ns(row.rows.median), ns(row.sums.median), ns(w.rows.front().near.median),
        ns(row.impact.median), row.row_length);
  fmt::print("near over inner, advection step with its acoustic steps (rows apart): {:.2f}\n", w.ratio);
}

}  // namespace

void print(const StepResult& s, const MachineResult& m) {
  fmt::print("\nStep, tube, {} particles, one thread, {:.0f} entries per row\n", s.particles, s.row_length);
  fmt::print("{:<28} {:>9} {:>9}\n", "ns per particle", "median", "best");
  print_acoustic(s, m);
  print_advection(s);
  fmt::print(
      "memory: largest resident size {:.0f} MB, {:.0f} bytes per particle (before the vessel: {:.0f} MB)\n",
      1e-6 * s.resident, s.resident / static_cast<double>(s.particles), 1e-6 * s.resident_before);
  print(s.walls);
}

void print(const KernelResult& r) {
  fmt::print("\nKernels, tube, {} particles, one thread\n", r.particles);
  fmt::print("{:<15} {:<14} {:>11} {:>11} {:>10} {:>8}\n", "", "", "median ns", "best ns", "Mps/s",
             "x plain");
  for (const auto& row : r.rows)
    fmt::print("{:<15} {:<14} {:11.1f} {:11.1f} {:10.2f} {:8.2f}\n", row.what, row.who,
               ns(row.per_particle.median), ns(row.per_particle.best), 1e-6 / row.per_particle.median,
               row.times_faster);
}

void print(const EngineResult& r) {
  fmt::print("\nEngine, {}, {} particles, {:.1f} acoustic steps per advection step, everything included\n",
             r.vessel, r.particles, r.acoustic_per_advection);
  fmt::print("{:<8} {:>16} {:>14} {:>12}\n", "threads", "Mps/s per core", "best", "preparation");
  for (const auto& row : r.rows)
    fmt::print("{:<8} {:16.2f} {:14.2f} {:10.0f} %\n", row.threads,
               1e-6 / row.per_particle_step.median / row.threads,
               1e-6 / row.per_particle_step.best / row.threads, 100 * row.preparation);
}

}  // namespace ostium::bench
