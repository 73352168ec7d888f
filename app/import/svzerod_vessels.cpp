// Vessels and junctions. A compliance that lies on a node of given pressure, or on one with another compliance, and an
// inertance in series with a given flow would make states depend on each other: they are replaced by what is exactly
// equal, C dP/dt as a flow source, the sum of the compliances, L dQ/dt as a pressure source.
#include <cmath>

#include "app/import/svzerod_circuit.hpp"

namespace ostium::app::svzerod {

using config::Tree;

namespace {

struct Rcl {
  double R, C, L, S;
  bool early;  // the resistance stands before the compliance
  bool lossless() const { return R == 0 && S == 0; }
};

bool is_vessel(const Part& part) { return part.type == "BloodVessel" || part.type == "BloodVesselCRL"; }

Rcl read(const Part& part) {
  part.values.check_keys({"R_poiseuille", "C", "L", "stenosis_coefficient"});
  const auto at_least_zero = [&](const char* key) {
    const auto found = part.values.find(key);
    return found ? found->non_negative() : 0.0;
  };
  return {part.values.at("R_poiseuille").number(), at_least_zero("C"), at_least_zero("L"),
          part.values.number("stenosis_coefficient", 0), part.type == "BloodVessel"};
}

/// The series of a flow that is given at the connection itself or beyond parts that let it pass.
std::optional<Series> given_flow(const Source& source, int connection, bool downstream) {
  for (std::size_t passed = 0; passed <= source.connections.size(); ++passed) {  // more would be a ring
    const auto& c = source.connections[connection];
    const Part& next = source.parts[downstream ? c.down : c.up];
    if (next.type == "FLOW") return read_series(next.values, "Q");
    const bool passes = (is_vessel(next) && read(next).C == 0) ||
                        (next.type == "NORMAL_JUNCTION" && next.in.size() == 1 && next.out.size() == 1);
    if (!passes) return std::nullopt;
    connection = downstream ? next.out[0] : next.in[0];
  }
  return std::nullopt;
}

std::optional<Series> through_inertance(const Source& source, const Part& part, const Rcl& v) {
  if (v.L == 0) return std::nullopt;
  if (auto flow = given_flow(source, part.out[0], true)) return flow;
  return v.C == 0 ? given_flow(source, part.in[0], false) : std::nullopt;
}

/// The connection whose node the compliance lies on; nothing where it has a node of its own.
std::optional<int> exposed(const Source& source, const Part& part) {
  const Rcl v = read(part);
  if (v.C == 0) return std::nullopt;
  const bool no_inertance = v.L == 0 || through_inertance(source, part, v);
  if (!v.early) return part.in[0];
  if (no_inertance) return part.out[0];
  return v.lossless() ? std::optional(part.in[0]) : std::nullopt;
}

/// Compliances on one node: all of them as one, on the first vessel.
struct Shared {
  const Part* owner = nullptr;
  double sum = 0, charge = 0;  // C, and C times pressure at the start, units of the file
};

double pressure_at_start(const Circuit& circuit, const Part& part, const Rcl& v) {
  const auto& name = circuit.source.connections[part.in[0]].name;
  const double p = circuit.source.start("pressure:" + name), q = circuit.source.start("flow:" + name);
  return v.early ? p - (v.R + v.S * std::abs(q)) * q : p;
}

Shared shared_at(const Circuit& circuit, int connection) {
  Shared shared;
  for (const Part* part : circuit.parts_at(connection)) {
    if (!is_vessel(*part)) continue;
    const auto at = exposed(circuit.source, *part);
    if (!at || !circuit.same_node(*at, connection)) continue;
    const Rcl v = read(*part);
    if (!shared.owner) shared.owner = part;
    shared.sum += v.C, shared.charge += v.C * pressure_at_start(circuit, *part, v);
  }
  return shared;
}

const Part* pressure_source_at(const Circuit& circuit, int connection) {
  for (const Part* part : circuit.parts_at(connection))
    if (part->type == "PRESSURE") return part;
  return nullptr;
}

class Vessel {
 public:
  Vessel(Circuit& circuit, const Part& part)
      : circuit_(circuit),
        part_(part),
        v_(read(part)),
        own_C_(v_.C),
        exposed_(exposed(circuit.source, part)) {}

  void add() {
    start_ = pressure_at_start(circuit_, part_, v_);
    settle_compliance();
    const std::string to = settle_inertance();
    add_block(to);
    tell_flows();
  }

 private:
  Expression q() const { return Expression::flow(part_.name); }
  Expression q_out() const { return Expression::flow(part_.name + ".q_out"); }

  void settle_compliance() {
    if (!exposed_) return;
    if (const Part* source = pressure_source_at(circuit_, *exposed_)) {
      Tree sink = Tree::map();
      sink.add("from", Tree::scalar(circuit_.node(*exposed_)));
      sink.add("flow", circuit_.rate(read_series(source->values, "P"), circuit_.units.flow, v_.C));
      circuit_.block(part_.name + ".C", "flow_source", std::move(sink));
      charging_ = Expression::flow(part_.name + ".C");
      v_.C = 0;
      return;
    }
    const Shared shared = shared_at(circuit_, *exposed_);
    if (shared.sum == v_.C) return;
    const std::string owner = shared.owner->name;
    charging_ = (own_C_ / shared.sum) * (Expression::flow(owner) - Expression::flow(owner + ".q_out"));
    v_.C = shared.owner == &part_ ? shared.sum : 0;
    start_ = shared.charge / shared.sum;
  }

  /// The node the block itself leads to.
  std::string settle_inertance() {
    const auto flow = through_inertance(circuit_.source, part_, v_);
    const std::string outlet = circuit_.outlet(part_);
    if (!flow) return outlet;
    const double L = v_.L;
    v_.L = 0;
    if (flow->constant()) return outlet;
    const std::string name = part_.name + ".L";
    Tree drop = Tree::map();
    drop.add("from", Tree::scalar(name)).add("to", Tree::scalar(outlet));
    drop.add("pressure", circuit_.rate(*flow, circuit_.units.pressure, -L));
    circuit_.block(name, "pressure_source", std::move(drop));
    return name;
  }

  void add_block(const std::string& to) {
    const auto& u = circuit_.units;
    Tree t = Tree::map();
    t.add("from", Tree::scalar(circuit_.inlet(part_))).add("to", Tree::scalar(to));
    t.add("R", circuit_.value(v_.R, u.resistance));
    if (v_.C > 0) t.add("C", circuit_.value(v_.C, u.compliance));
    if (v_.L > 0) t.add("L", circuit_.value(v_.L, u.inertance));
    if (v_.S != 0) t.add("K", circuit_.value(v_.S, u.stenosis));
    if (!v_.early) t.add("order", Tree::scalar("CRL"));
    if (v_.R < 0 || v_.S < 0) t.add("fitted", Tree::scalar("true"));
    if (v_.C > 0)
      t.add("initial_pressure", circuit_.start_value(Expression::pressure(part_.name + ".u"),
                                                     circuit_.si(start_, u.pressure), u.pressure));
    if (v_.L > 0) {
      const auto& outlet = circuit_.source.connections[part_.out[0]].name;
      t.add("initial_flow",
            circuit_.start_value(q_out(), circuit_.from_file("flow:" + outlet, u.flow), u.flow));
    }
    circuit_.block(part_.name, "vessel", std::move(t));
  }

  /// What charges a compliance that the block does not have is added to the flow at its end.
  void tell_flows() {
    const bool at_inlet = charging_ && exposed_ == part_.in[0];
    circuit_.flow_in(part_, at_inlet ? q_out() + *charging_ : q());
    circuit_.flow_out(part_, charging_ && !at_inlet ? q() - *charging_ : q_out());
  }

  Circuit& circuit_;
  const Part& part_;
  Rcl v_;
  double own_C_, start_ = 0;
  std::optional<int> exposed_;
  std::optional<Expression> charging_;
};

void translate_rc(Circuit& circuit, const Part& part) {
  part.values.check_keys({"Rpd", "Cp"});
  const auto& u = circuit.units;
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part))).add("to", Tree::scalar(circuit.outlet(part)));
  t.add("R", circuit.value(part.values.at("Rpd").positive(), u.resistance));
  t.add("C", circuit.value(part.values.at("Cp").positive(), u.compliance));
  t.add("stores", Tree::scalar("false"));
  const auto& inlet = circuit.source.connections[part.in[0]].name;
  t.add("initial_pressure",
        circuit.start_value(Expression::pressure(part.name + ".u"),
                            circuit.from_file("pressure:" + inlet, u.pressure), u.pressure));
  circuit.block(part.name, "rc", std::move(t));
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.flow_out(part, Expression::flow(part.name + ".q_out"));
}

void add_branch(Circuit& circuit, const std::string& name, const std::string& from, const std::string& to,
                double R, double L, double S, const std::string& outlet) {
  const auto& u = circuit.units;
  Tree t = Tree::map();
  t.add("from", Tree::scalar(from)).add("to", Tree::scalar(to)).add("R", circuit.value(R, u.resistance));
  if (L > 0) t.add("L", circuit.value(L, u.inertance));
  if (S != 0) t.add("K", circuit.value(S, u.stenosis));
  if (R < 0 || S < 0) t.add("fitted", Tree::scalar("true"));
  if (L > 0)
    t.add("initial_flow", circuit.start_value(Expression::flow(name + ".q_out"),
                                              circuit.from_file("flow:" + outlet, u.flow), u.flow));
  circuit.block(name, "vessel", std::move(t));
}

/// One branch per outlet that has a loss.
void translate_losses(Circuit& circuit, const Part& part) {
  const auto list = [&](const char* key) { return part.values.at(key).numbers(); };
  const auto R = list("R_poiseuille"), L = list("L"), S = list("stenosis_coefficient");
  for (std::size_t i = 0; i < part.out.size(); ++i) {
    if (L[i] < 0) part.values.at("L").items()[i].error("must be >= 0, found {:g}", L[i]);
    if (circuit.same_node(part.in[0], part.out[i])) continue;
    const auto& c = circuit.source.connections[part.out[i]];
    add_branch(circuit, part.name + "." + circuit.source.parts[c.down].name, circuit.node(part.in[0]),
               circuit.node(part.out[i]), R[i], L[i], S[i], c.name);
  }
}

/// A star of resistances around the pressure pressure_c.
void translate_star(Circuit& circuit, const Part& part) {
  part.values.check_keys({"R"});
  const auto R = part.values.at("R").numbers();
  if (R.size() != part.in.size() + part.out.size())
    part.values.at("R").error(
        "has {} values for the {} ends of the junction; give one per inlet, then one per outlet", R.size(),
        part.in.size() + part.out.size());
  const std::string centre = part.name + ".c";
  for (std::size_t i = 0; i < R.size(); ++i) {
    const bool inlet = i < part.in.size();
    const int c = inlet ? part.in[i] : part.out[i - part.in.size()];
    const auto& joined = circuit.source.connections[c];
    const std::string name = part.name + "." + circuit.source.parts[inlet ? joined.up : joined.down].name;
    add_branch(circuit, name, inlet ? circuit.node(c) : centre, inlet ? centre : circuit.node(c), R[i], 0, 0,
               {});
  }
  circuit.internal(part, "pressure_c", circuit.units.pressure, Expression::pressure(centre));
}

}  // namespace

void translate_vessel(Circuit& circuit, const Part& part) {
  if (part.type == "BloodVesselRC") return translate_rc(circuit, part);
  if (part.type == "ChamberSphere") return translate_chamber(circuit, part);
  Vessel(circuit, part).add();
}

void translate_junction(Circuit& circuit, const Part& part) {
  if (part.type == "BloodVesselJunction") translate_losses(circuit, part);
  if (part.type == "resistive_junction") translate_star(circuit, part);
}

}  // namespace ostium::app::svzerod
