/// The network that is made of a svZeroDSolver model: nodes, blocks with their start values, and what each unknown of
/// that program is in terms of ours.
///
///   node of a connection     "UP:DOWN"; all connections of a NORMAL_JUNCTION are one node of its name
///   block                    of the part's name; what a part needs beside it is called PART.WHAT
///   flow_in, flow_out        of each part, from which the flow of each connection follows (else Kirchhoff's law at
///                            the junctions)
///
/// `stage`: the model itself, or the "steady" one from whose end that program starts: sources at their means, no
/// compliance in the outlets. Values of the file are written in the units `units`.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/import/expression.hpp"
#include "app/import/svzerod_source.hpp"
#include "app/import/unit_system.hpp"
#include "core/config/tree.hpp"

namespace ostium::app::svzerod {

enum class Stage { steady, run };

/// The last values of the steady stage by series, SI.
using Values = std::map<std::string, double>;

class Circuit {
 public:
  Circuit(const Source& source, const UnitSystem& units, Stage stage, const Values* steady);

  const Source& source;
  const UnitSystem& units;
  const Stage stage;

  /// Joins the nodes of two connections to one; before any node is named.
  void join(int a, int b);
  void name_node(int connection, const std::string& name);
  std::string node(int connection) const;
  std::string inlet(const Part& part) const { return node(part.in.at(0)); }
  std::string outlet(const Part& part) const { return node(part.out.at(0)); }
  bool same_node(int a, int b) const { return root(a) == root(b); }
  /// All parts with a connection at this node.
  std::vector<const Part*> parts_at(int connection) const;

  /// Adds a block; `fields` without `type`.
  void block(const std::string& name, const std::string& type, config::Tree fields);
  config::Tree value(double in_file_units, const std::string& unit) const;
  /// SI from the units of the file.
  double si(double in_file_units, const std::string& unit) const;
  /// A source: the series, its mean in the steady stage. `factor` for the other sign.
  config::Tree waveform(const Series& series, const std::string& unit, double factor = 1) const;
  /// The rate of the series times `factor`, whose unit is `unit`: steps, each with the value before it at a kink.
  config::Tree rate(const Series& series, const std::string& unit, double factor) const;

  /// Start value of a state: of the end of the steady stage, where there was one, else what the file says (SI).
  double start(const Expression& in_steady_stage, double from_file) const;
  config::Tree start_value(const Expression& in_steady_stage, double from_file,
                           const std::string& unit) const;
  /// SI: what the file says of an unknown that has `unit`.
  double from_file(const std::string& unknown, const std::string& unit) const;

  void flow_in(const Part& part, Expression e) { in_[part.name] = std::move(e); }
  void flow_out(const Part& part, Expression e) { out_[part.name] = std::move(e); }
  /// An unknown of the part's own, VARIABLE:PART.
  void internal(const Part& part, const std::string& variable, const std::string& unit, Expression e);
  void note(const std::string& text) { notes.push_back(text); }

  /// Mapping of blocks; mapping of `UNKNOWN: [unit, terms..]` in the order of that program.
  config::Tree blocks = config::Tree::map();
  config::Tree variables() const;
  std::vector<std::string> notes;

 private:
  struct Internal {
    std::string name, unit;
    Expression value;
  };
  int root(int connection) const;
  std::vector<std::optional<Expression>> flows() const;
  bool balance(const Part& junction, std::vector<std::optional<Expression>>& flows) const;

  const Values* steady_;
  std::vector<int> parent_;
  std::map<int, std::string> names_;
  std::map<std::string, Expression> in_, out_;
  std::vector<Internal> internals_;
};

/// Adds all parts of the source (svzerod_translate.cpp); throws UserError.
void translate(Circuit& circuit);

/// By kind of part.
void translate_vessel(Circuit& circuit, const Part& part);
void translate_boundary(Circuit& circuit, const Part& part);
void translate_valve(Circuit& circuit, const Part& part);
void translate_chamber(Circuit& circuit, const Part& part);
void translate_heart(Circuit& circuit, const Part& part);
void translate_junction(Circuit& circuit, const Part& part);

}  // namespace ostium::app::svzerod
