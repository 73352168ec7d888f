/// The case file: everything a run needs, as declared fields (`ostium reference` prints them, `ostium check`
/// checks them).
///
/// All values are SI. A case without `vessel` is a standalone study of its network.
/// Checked here: each field by itself, and which fields belong together. Not checked here: surface, openings,
/// graph.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/wall_case.hpp"
#include "core/config.hpp"
#include "network/design.hpp"
#include "network/simulate.hpp"
#include "sph3d/openings/profile.hpp"

namespace ostium::app {

/// Which opening of the surface a name means, and its velocity profile where the network prescribes its flow.
struct OpeningCase {
  std::optional<int> largest, edge;
  std::optional<std::vector<double>> nearest;  // m
  std::optional<std::string> label;
  sph3d::Profile profile = sph3d::Profile::parabolic;
  config::Node origin;
};

struct VesselCase {
  int dimension = 3;
  std::optional<std::filesystem::path> surface;
  std::optional<config::Node> outline;
  std::optional<double> length_unit;  // m
  double spacing = 0;                 // m
  bool cap_open_ends = false;
  std::vector<std::pair<std::string, OpeningCase>> openings;
  WallCase wall;
  config::Node origin;
};

struct FluidCase {
  double density = 0, viscosity = 0;  // kg/m3, Pa.s
  std::optional<double> sound_speed;  // m/s
  config::Node origin;
};

struct NetworkCase {
  config::Node blocks;  // without uses of subnetworks: read_case has replaced them
  std::optional<config::Node> subnetworks;
  std::optional<network::Initial> initial;
  std::optional<bool> periodic;  // the same as yes or no
};

enum class Scheme { linearised, held, extrapolated, modified_euler };

struct CouplingCase {
  Scheme scheme = Scheme::linearised;
  std::optional<double> exchange, filter_time, datum_time;  // s
  bool force = false;
};

struct TimeCase {
  std::optional<double> period, end;  // s
  std::optional<int> cycles;
  double final() const { return end ? *end : *period * cycles.value_or(1); }
};

/// What `ostium run --format svzerod` writes: another program's unknowns in terms of our series.
struct SvzerodCase {
  bool all_cycles = false, mean_only = false;
  std::optional<config::Node> variables;  // UNKNOWN: [unit, terms..]
  std::optional<config::Node> start;      // UNKNOWN: value of the first row
};

/// A point of the blood, or of the wall, that is watched.
struct ProbeCase {
  std::vector<double> at;  // m
  bool on_wall = false;
  config::Node origin;
};

struct OutputCase {
  double every = 0, from = 0;          // s
  std::optional<double> fields_every;  // s
  double checkpoint_every = 0;         // s of wall time
  std::vector<std::pair<std::string, ProbeCase>> probes;
  SvzerodCase svzerod;
};

/// Derivatives of results with respect to parameters, for a network alone.
struct SensitivityCase {
  std::vector<std::string> of, to;
  config::Node origin;
};

/// What a calibration of a network alone has to meet, and what it may change; values are texts with units, since their
/// dimension is that of the result or the parameter.
struct TargetCase {
  std::string of, value, tolerance;
  double weight = 1;
  config::Node origin;
};

struct FreeParameterCase {
  std::string name, low, high;
  bool logarithmic = true;
  config::Node origin;
};

struct CalibrationCase {
  std::vector<TargetCase> targets;
  std::vector<FreeParameterCase> parameters;
  int most_runs = 60;
  config::Node origin;
};

/// How a parameter varies in a sweep; values are texts with units, as above.
struct SweptParameterCase {
  std::string name;
  std::optional<std::string> low, high, mean, standard_deviation;
  bool normal = false, logarithmic = false;
  std::optional<int> count;
  std::optional<std::vector<std::string>> values;
  config::Node origin;
};

struct SweepCase {
  std::optional<network::Sampling> sample;
  std::optional<std::filesystem::path> file;
  std::optional<long> count;
  long seed = 1;
  std::vector<SweptParameterCase> parameters;
  std::vector<std::string> results;
  config::Node origin;
};

/// Numbers of the methods; a user needs none of them.
struct NumericsCase {
  double advection_cfl = 0, acoustic_cfl = 0, shift = 0, limiter = 0, density_relaxation = 0;
  std::optional<double> reference_speed;  // m/s
};

struct Case {
  std::string title;
  std::optional<VesselCase> vessel;
  FluidCase fluid;
  NetworkCase network;
  CouplingCase coupling;
  TimeCase time;
  OutputCase output;
  NumericsCase numerics;
  std::optional<SensitivityCase> sensitivities;
  std::optional<CalibrationCase> calibration;
  std::optional<SweepCase> sweep;
  config::Node origin;

  /// As the case says, else periodic where the case has a period.
  network::Initial initial() const;
};

void declare(config::Fields<OpeningCase>&);
void declare(config::Fields<VesselCase>&);
void declare(config::Fields<FluidCase>&);
void declare(config::Fields<NetworkCase>&);
void declare(config::Fields<CouplingCase>&);
void declare(config::Fields<TimeCase>&);
void declare(config::Fields<SvzerodCase>&);
void declare(config::Fields<ProbeCase>&);
void declare(config::Fields<OutputCase>&);
void declare(config::Fields<NumericsCase>&);
void declare(config::Fields<SensitivityCase>&);
void declare(config::Fields<TargetCase>&);
void declare(config::Fields<FreeParameterCase>&);
void declare(config::Fields<CalibrationCase>&);
void declare(config::Fields<SweptParameterCase>&);
void declare(config::Fields<SweepCase>&);
void declare(config::Fields<Case>&);

/// What the command line changes in a case: another surface, values at dotted paths ("time.cycles", "1").
struct Overrides {
  std::optional<std::filesystem::path> surface;
  std::vector<std::pair<std::string, std::string>> values;
};

/// Throws UserError with position.
Case read_case(const std::filesystem::path& file, const Overrides& overrides = {});
Case read_case(const config::Node& document, const Overrides& overrides = {});

/// The name of a case: of its file, or of the folder of a file called case.yaml.
std::string case_name(const std::filesystem::path& file);

}  // namespace ostium::app
