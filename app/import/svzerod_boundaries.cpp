// Boundary conditions and coupling blocks: sources, resistances, Windkessels, coronary beds.
#include "app/import/svzerod_circuit.hpp"

namespace ostium::app::svzerod {

using config::Tree;

namespace {

/// The end it has: of a flow into the network, or out of it.
std::string end_key(const Part& part) { return part.in.empty() ? "to" : "from"; }
std::string end_node(const Circuit& circuit, const Part& part) {
  return part.in.empty() ? circuit.outlet(part) : circuit.inlet(part);
}

void tell_flow(Circuit& circuit, const Part& part, const Expression& e) {
  part.in.empty() ? circuit.flow_out(part, e) : circuit.flow_in(part, e);
}

void translate_source(Circuit& circuit, const Part& part) {
  const bool flow = part.type == "FLOW";
  part.values.check_keys({"t", flow ? "Q" : "P"});
  const Series series = read_series(part.values, flow ? "Q" : "P");
  Tree t = Tree::map();
  t.add(end_key(part), Tree::scalar(end_node(circuit, part)));
  t.add(flow ? "flow" : "pressure",
        circuit.waveform(series, flow ? circuit.units.flow : circuit.units.pressure));
  circuit.block(part.name, flow ? "flow_source" : "pressure_source", std::move(t));
  tell_flow(circuit, part, Expression::flow(part.name));
}

void needs_inlet(const Part& part) {
  if (part.in.empty())
    part.node.error(
        "a {} stands at the outlet of a vessel, this one is at an inlet; take FLOW or PRESSURE there",
        part.type);
}

/// To the distal pressure through R alone; R = 0 gives the pressure itself.
void add_resistance(Circuit& circuit, const Part& part, double R, double Pd) {
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part)));
  if (R > 0) t.add("R", circuit.value(R, circuit.units.resistance));
  t.add(R > 0 ? "ground" : "pressure", circuit.value(Pd, circuit.units.pressure));
  circuit.block(part.name, R > 0 ? "resistor" : "pressure_source", std::move(t));
  circuit.flow_in(part, Expression::flow(part.name));
}

void translate_resistance(Circuit& circuit, const Part& part) {
  needs_inlet(part);
  part.values.check_keys({"R", "Pd"});
  add_resistance(circuit, part, part.values.at("R").non_negative(), part.values.at("Pd").number());
}

void translate_rcr(Circuit& circuit, const Part& part) {
  needs_inlet(part);
  part.values.check_keys({"Rp", "C", "Rd", "Pd"});
  const auto& u = circuit.units;
  const double Rp = part.values.at("Rp").non_negative(), C = part.values.at("C").non_negative(),
               Rd = part.values.at("Rd").non_negative(), Pd = part.values.number("Pd", 0);
  const Expression stationary =
      Expression{{}, circuit.si(Pd, u.pressure)} + circuit.si(Rd, u.resistance) * Expression::flow(part.name);
  if (circuit.stage == Stage::steady || C == 0 || Rd == 0) {
    add_resistance(circuit, part, Rp + Rd, Pd);
    return circuit.internal(part, "pressure_c", u.pressure, stationary);
  }
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part))).add("Rp", circuit.value(Rp, u.resistance));
  t.add("C", circuit.value(C, u.compliance)).add("Rd", circuit.value(Rd, u.resistance));
  t.add("Pd", circuit.value(Pd, u.pressure));
  t.add(
      "initial_pressure",
      circuit.start_value(stationary, circuit.from_file("pressure_c:" + part.name, u.pressure), u.pressure));
  circuit.block(part.name, "windkessel", std::move(t));
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.internal(part, "pressure_c", u.pressure, Expression::pressure(part.name + ".Pc"));
}

/// Between two nodes; in the steady stage its compliance is left out.
void translate_closed_loop_rcr(Circuit& circuit, const Part& part) {
  part.values.check_keys({"Rp", "C", "Rd", "closed_loop_outlet"});
  const auto& u = circuit.units;
  const double Rp = part.values.at("Rp").non_negative(), C = part.values.at("C").non_negative(),
               Rd = part.values.at("Rd").non_negative();
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part))).add("to", Tree::scalar(circuit.outlet(part)));
  const Expression stationary =
      Expression::pressure(circuit.inlet(part)) - circuit.si(Rp, u.resistance) * Expression::flow(part.name);
  const bool without_C = circuit.stage == Stage::steady || C == 0 || Rd == 0;
  if (without_C) {
    t.add("R", circuit.value(Rp + Rd, u.resistance));
    circuit.block(part.name, "vessel", std::move(t));
    circuit.flow_out(part, Expression::flow(part.name + ".q_out"));
  } else {
    t.add("Rp", circuit.value(Rp, u.resistance)).add("C", circuit.value(C, u.compliance));
    t.add("Rd", circuit.value(Rd, u.resistance));
    t.add("initial_pressure",
          circuit.start_value(stationary, circuit.from_file("P_c:" + part.name, u.pressure), u.pressure));
    circuit.block(part.name, "windkessel", std::move(t));
    circuit.flow_out(
        part, 1 / circuit.si(Rd, u.resistance) *
                  (Expression::pressure(part.name + ".Pc") - Expression::pressure(circuit.outlet(part))));
  }
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.internal(part, "P_c", u.pressure, without_C ? stationary : Expression::pressure(part.name + ".Pc"));
}

struct Bed {
  double Ra, Ram, Rv, Ca, Cim, Pd;
};

/// Resistances, compliances and the start of the arteries' pressure.
Tree coronary(const Circuit& circuit, const Part& part, const Bed& b) {
  const auto& u = circuit.units;
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part)));
  t.add("Ra", circuit.value(b.Ra, u.resistance)).add("Ram", circuit.value(b.Ram, u.resistance));
  t.add("Rv", circuit.value(b.Rv, u.resistance)).add("Ca", circuit.value(b.Ca, u.compliance));
  t.add("Cim", circuit.value(b.Cim, u.compliance));
  const auto& inlet = circuit.source.connections[part.in[0]].name;
  const double Ra = circuit.si(b.Ra, u.resistance);
  const double from_file =
      circuit.from_file("pressure:" + inlet, u.pressure) - Ra * circuit.from_file("flow:" + inlet, u.flow);
  t.add("initial_pressure",
        circuit.start_value(Expression::pressure(circuit.inlet(part)) - Ra * Expression::flow(part.name),
                            from_file, u.pressure));
  return t;
}

/// Rises over T_vc, falls over T_vr, from the beginning of the beat.
Tree throttling(const Circuit& circuit, const Part& part) {
  const auto time = [&](const char* key) { return circuit.value(part.values.at(key).positive(), "s"); };
  Tree a = Tree::map();
  a.add("type", Tree::scalar("piecewise_cosine")).add("contract_start", circuit.value(0, "s"));
  a.add("contract_duration", time("T_vc"))
      .add("relax_start", time("T_vc"))
      .add("relax_duration", time("T_vr"));
  a.add("period", circuit.value(circuit.source.period, "s"));
  return a;
}

/// The volume of that program counts from the start of the run: from where the bed is in balance with its muscle.
void translate_open_coronary(Circuit& circuit, const Part& part) {
  needs_inlet(part);
  const bool varies = part.type == "CORONARY_VAR_RES";
  const auto& v = part.values;
  if (varies)
    v.check_keys({"Ra1", "Ra2_min", "Ra2_max", "Rv1", "Ca", "Cc", "P_v", "t", "Pim", "T_vc", "T_vr"});
  else
    v.check_keys({"Ra1", "Ra2", "Rv1", "Ca", "Cc", "P_v", "t", "Pim"});
  const Bed b{v.at("Ra1").non_negative(), v.at(varies ? "Ra2_min" : "Ra2").positive(),
              v.at("Rv1").positive(),     v.at("Ca").non_negative(),
              v.at("Cc").positive(),      v.at("P_v").number()};
  const Series Pim = read_series(v, "Pim");
  if (circuit.stage == Stage::steady) return add_resistance(circuit, part, b.Ra + b.Ram + b.Rv, b.Pd);

  const auto& u = circuit.units;
  const auto& inlet = circuit.source.connections[part.in[0]].name;
  const double Rv = circuit.si(b.Rv, u.resistance), Cim = circuit.si(b.Cim, u.compliance);
  const double q = circuit.from_file("flow:" + inlet, u.flow);
  const double without_steady =
      circuit.from_file("pressure:" + inlet, u.pressure) - circuit.si(b.Ra + b.Ram, u.resistance) * q;
  const double p = circuit.start(
      Expression{{}, circuit.si(b.Pd, u.pressure)} + Rv * Expression::flow(part.name), without_steady);
  const double muscle =
      circuit.si(circuit.source.run.steady_initial ? Pim.mean() : Pim.values.front(), u.pressure);
  const double datum = Cim * (p - muscle);
  const double V = datum + circuit.from_file("volume_im:" + part.name, u.volume);

  Tree t = coronary(circuit, part, b);
  t.add("Pim", circuit.waveform(Pim, u.pressure)).add("Pd", circuit.value(b.Pd, u.pressure));
  t.add("initial_volume", circuit.value(V / circuit.si(1, u.volume), u.volume));
  if (varies) {
    t.add("Ram_max", circuit.value(v.at("Ra2_max").positive(), u.resistance));
    t.add("activation", throttling(circuit, part));
  }
  circuit.block(part.name, "coronary", std::move(t));
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.internal(part, "volume_im", u.volume,
                   Expression::volume(part.name + ".V") + Expression{{}, -datum});
}

/// Squeezed by a ventricle of the heart, of whose pressure `iml` or `imr` reaches the muscle.
void translate_closed_loop_coronary(Circuit& circuit, const Part& part) {
  const auto& v = part.values;
  v.check_keys({"Ra", "Ram", "Rv", "Ca", "Cim"});
  if (!circuit.source.has("ClosedLoopHeartAndPulmonary"))
    part.node.error("a {} needs a heart: add a ClosedLoopHeartAndPulmonary to \"closed_loop_blocks\"",
                    part.type);
  const auto& u = circuit.units;
  const Bed b{v.at("Ra").non_negative(), v.at("Ram").positive(), v.at("Rv").positive(),
              v.at("Ca").non_negative(), v.at("Cim").positive(), 0};
  const bool left = part.type == "ClosedLoopCoronaryLeft";
  Tree t = coronary(circuit, part, b);
  t.add("to", Tree::scalar(circuit.outlet(part))).add("ventricle", Tree::scalar(left ? "CLH.LV" : "CLH.RV"));
  t.add("share", circuit.value(circuit.source.part("CLH").values.at(left ? "iml" : "imr").number(), ""));
  const Expression V = Expression::volume(part.name + ".V");
  t.add("initial_volume",
        circuit.start_value(V, circuit.from_file("volume_im:" + part.name, u.volume), u.volume));
  circuit.block(part.name, "coronary", std::move(t));
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.flow_out(part, Expression::flow(part.name + ".q_out"));
  circuit.internal(part, "volume_im", u.volume, V);
}

}  // namespace

void translate_boundary(Circuit& circuit, const Part& part) {
  if (part.type == "FLOW" || part.type == "PRESSURE") return translate_source(circuit, part);
  if (part.type == "RESISTANCE") return translate_resistance(circuit, part);
  if (part.type == "RCR") return translate_rcr(circuit, part);
  if (part.type == "ClosedLoopRCR") return translate_closed_loop_rcr(circuit, part);
  if (part.type.starts_with("ClosedLoopCoronary")) return translate_closed_loop_coronary(circuit, part);
  translate_open_coronary(circuit, part);
}

}  // namespace ostium::app::svzerod
