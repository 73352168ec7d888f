/// What ostium-bench measures.
///
///   machine   of one core: single-precision multiply-add rate, memory rate (triad)
///   step      the fluid of a tube on one thread: acoustic step, advection step by part, walls, memory
///   kernels   on one thread, all rivals in turn: the acoustic step (kick and density) and the sums of the advection step,
///             ns per particle; `plain` is the double-precision reference with stored pairs
///   engine    whole advection steps of a vessel with everything they contain, on one thread and two; a particle-step is
///             one particle through one acoustic step, its share of the advection step included
///   shell     a shell's step by law and number of particles, on one thread
///
/// Ratios of these figures are compared with a stored baseline: times on different machines, or beside other work, cannot be.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measure.hpp"

namespace ostium::sph3d {
template <int D>
class Vessel;
}

namespace ostium::bench {

struct Options {
  double particles = 60000;            // of the tube
  std::filesystem::path surface = {};  // of the vessel for the engine; empty: a generated arch
  double length_unit = 1e-2;           // m per unit of that file
  double spacing = 1e-3;               // m, for the engine
  int rounds = 7;
  bool shell_only = false;
  std::filesystem::path json = {}, baseline = {}, write_baseline = {};
};

/// Best of several tries, of one core.
struct MachineResult {
  double multiply_add = 0, triad = 0;  // flop/s, bytes/s
  std::string vectors;
  double load =
      0;  // average of the minute before: above the number of cores, wall times (engine) are disturbed
  int cores = 0;
};

/// A part of a step, s per particle each time it is done.
struct Part {
  std::string name;
  Timing time;
  double share = 1;  // of advection steps that have it
  double mean() const { return share * time.median; }
};

/// Clusters with a particle that feels the wall, and those without: s per particle.
struct WallResult {
  double near_share = 0;  // of the clusters
  struct Row {
    std::string what;
    Timing near, inner;
  };
  std::vector<Row> rows = {};
  double ratio = 0;  // near over inner, of an advection step with its acoustic steps
  /// Virtual layers in place of the filling field, which takes `look around` and nothing in the acoustic steps.
  struct LayerRow {
    double spacing = 0, row_length = 0;  // of the shell, over dp; shell particles per cluster
    Timing rows, sums, impact;           // advection step: row lists and sums; each acoustic step
  };
  std::vector<LayerRow> layers = {};
};

struct StepResult {
  std::size_t particles = 0;
  double row_length = 0, acoustic_per_advection = 0;
  Timing kick = {}, density = {}, driving = {};  // driving of the ports, in each acoustic step
  std::vector<Part> parts = {};                  // of the advection step, each on its own
  /// As they are in a run of the vessel, s per particle; the advection step's acoustic steps apart.
  Timing acoustic_in_run = {}, advection_in_run = {};
  Timing wall_fields =
      {};  // sampling the wall and adding to its cycle, in each advection step: not part of it
  double advection_over_acoustic = 0;        // median of the rounds' ratios
  double resident = 0, resident_before = 0;  // bytes: largest so far, and before the vessel was made
  WallResult walls = {};

  double acoustic() const { return kick.median + driving.median + density.median; }
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

struct ShellRow {
  std::string law;
  std::size_t particles;
  Timing per_step;  // s per particle
};

struct ShellResult {
  std::vector<ShellRow> rows;
};

struct Results {
  MachineResult machine;
  StepResult step;
  KernelResult kernels;
  EngineResult engine;
};

MachineResult measure_machine();
/// `resident_before`: see StepResult.
StepResult measure_step(sph3d::Vessel<3>& tube, const Options& options, double resident_before);
WallResult measure_walls(const sph3d::Vessel<3>& tube, double acoustic_per_advection, int rounds);
KernelResult measure_kernels(const sph3d::Vessel<3>& tube, const Options& options);
EngineResult measure_engine(const Options& options);
ShellResult measure_shell(const Options& options);

/// Largest resident size of this process so far, bytes.
double peak_resident();

void print(const MachineResult& machine);
void print(const StepResult& step, const MachineResult& machine);
void print(const KernelResult& kernels);
void print(const EngineResult& engine);
void print(const ShellResult& shell);
void write_json(const Results& results, const std::filesystem::path& file);

}  // namespace ostium::bench
