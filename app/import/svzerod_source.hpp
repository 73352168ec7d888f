/// A svZeroDSolver model as its file has it: parts (blocks), who is joined to whom, and how it is to be run.
///
///   connection   UP -> DOWN, one node of that program: unknowns flow:UP:DOWN (positive along the arrow) and
///                pressure:UP:DOWN, in the order in which the file makes them
///   series       t, values: piecewise linear, repeated after t[last] - t[0]; one sample is a constant
///   period       of the series, of `cardiac_cycle_period`, of `cardiac_period` (all the same), else 1
///
/// Source: docs of svZeroDSolver (SimVascular, BSD 3-clause). Checked here: names, kinds, which parts are joined.
/// Not checked: parameters, which the translation of each type does.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/import/json_node.hpp"

namespace ostium::app::svzerod {

/// How far a stage that takes its time is, by name: share 0 to 1.
using Tell = std::function<void(const std::string& stage, double share)>;
inline void nobody(const std::string&, double) {}

enum class Kind { vessel, coupling, boundary, junction, heart, valve, chamber };

/// A block of that program.
struct Part {
  Kind kind;
  std::string name, type;
  JsonNode node;             // the whole entry
  JsonNode values;           // its parameters
  std::vector<int> in, out;  // connections
};

struct Connection {
  int up, down;      // parts
  std::string name;  // "UP:DOWN"
};

/// A function of time as sampled in the file.
struct Series {
  std::vector<double> t, values;
  JsonNode where;
  bool constant() const;
  double period() const { return t.size() > 1 ? t.back() - t.front() : 0; }
  double mean() const;  // of the samples, each counting the same: what that program starts from
};
/// `values.t` and `values.KEY`.
Series read_series(const JsonNode& values, const std::string& key);

struct Run {
  int cycles = 1, points = 2, interval = 1;
  bool steady_initial = true, all_cycles = false, mean_only = false;
  std::optional<double> cycle_error;  // ratio
};

struct Source {
  explicit Source(const JsonNode& file) : root(file) {}

  JsonNode root;
  std::string title;
  Run run;
  double period = 1;
  std::vector<Part> parts;
  std::vector<Connection> connections;
  std::map<std::string, double> initial, initial_rates;

  const Part& part(const std::string& name) const;
  bool has(const std::string& type) const;
  /// What the file says of an unknown at the start: by its name, by `pressure_all`, `flow_all`, else 0.
  double start(const std::string& unknown) const;
};

/// Throws UserError with file and JSON path. `notes` gets what is left out.
Source read_source(const JsonNode& root, std::vector<std::string>& notes);

/// The steps of read_source: parts and connections; how it is run.
void read_parts(Source& source);
void read_run(Source& source, std::vector<std::string>& notes);

}  // namespace ostium::app::svzerod
