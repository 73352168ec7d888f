/// What ostium-bench measures.
///
///   kernels   on one thread, all rivals in turn: the acoustic step (kick and density) and the sums of the advection step
///             (sums and corrected sums), ns per particle; `plain` is the double-precision reference with stored pairs
///   engine    whole advection steps of a vessel with everything they contain; a particle-step is one particle through one
///             acoustic step, its share of the advection step included
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "sph3d/geometry/lumen.hpp"

namespace ostium::bench {

struct Options {
  double particles = 60000;            // of the tube for the kernels
  std::filesystem::path surface = {};  // of the vessel for the engine; empty: a generated arch
  double length_unit = 1e-2;           // m per unit of that file
  double spacing = 1e-3;               // m, for the engine
  int rounds = 7;
  std::filesystem::path json = {};
};

struct KernelRow {
  std::string what, who;
  Timing per_particle;      // s
  double times_faster = 1;  // than the plain reference, by medians
};

struct KernelResult {
  std::size_t particles = 0;
  std::vector<KernelRow> rows = {};
};

struct EngineRow {
  int threads = 0;
  Timing per_particle_step;  // s of wall time
  double preparation = 0;    // share of the time spent before the acoustic steps of each advection step
};

struct EngineResult {
  std::string vessel;
  std::size_t particles = 0;
  double acoustic_per_advection = 0;
  std::vector<EngineRow> rows;
};

sph3d::Lumen<3> tube_of(double particles, double spacing);
sph3d::Lumen<3> engine_vessel(const Options& options, std::string& name);

KernelResult measure_kernels(const Options& options);
EngineResult measure_engine(const Options& options);

}  // namespace ostium::bench
