// Chambers and valves.
#include "app/import/svzerod_chambers.hpp"
#include "core/did_you_mean.hpp"

namespace ostium::app::svzerod {

using config::Tree;

Tree activation_of(const char* type) {
  Tree t = Tree::map();
  t.add("type", Tree::scalar(type));
  return t;
}

Tree start_volume(const Circuit& circuit, const std::string& state, const std::string& unknown) {
  const auto& unit = circuit.units.volume;
  return circuit.start_value(Expression::volume(state), circuit.from_file(unknown, unit), unit);
}

namespace {

/// `activation_function` of a chamber.
Tree activation(const Circuit& circuit, const Part& part) {
  const auto f = part.node.at("activation_function");
  const std::string type = f.at("type").text();
  const double T = circuit.source.period;
  const auto seconds = [&](const char* key) { return circuit.value(f.at(key).number(), "s"); };
  const auto lasting = [&](const char* key) { return circuit.value(f.at(key).positive(), "s"); };
  Tree a = Tree::map();
  if (type == "half_cosine") {
    f.check_keys({"type", "t_active", "t_twitch"});
    a = activation_of("half_cosine").add("start", seconds("t_active")).add("duration", lasting("t_twitch"));
  } else if (type == "piecewise_cosine") {
    f.check_keys({"type", "contract_start", "relax_start", "contract_duration", "relax_duration"});
    a = activation_of("piecewise_cosine").add("contract_start", seconds("contract_start"));
    a.add("contract_duration", lasting("contract_duration")).add("relax_start", seconds("relax_start"));
    a.add("relax_duration", lasting("relax_duration"));
  } else if (type == "two_hill") {
    f.check_keys({"type", "t_shift", "tau_1", "tau_2", "m1", "m2"});
    a = activation_of("double_hill").add("start", seconds("t_shift"));
    a.add("tau_1", lasting("tau_1")).add("tau_2", lasting("tau_2"));
    a.add("m1", circuit.value(f.at("m1").positive(), "")).add("m2", circuit.value(f.at("m2").positive(), ""));
  } else if (type == "wrapping_cosine") {
    f.check_keys({"type", "Tsa", "tpwave"});
    a = activation_of("wrapping_cosine").add("end", circuit.value(T / f.at("tpwave").positive(), "s"));
    a.add("duration", circuit.value(T * f.at("Tsa").positive(), "s"));
  } else if (type == "fourier") {
    f.check_keys({"type"});
    a = activation_of("ventricle");
  } else {
    f.at("type").error(
        "there is no activation \"{}\"{}", type,
        did_you_mean(type, {"half_cosine", "piecewise_cosine", "two_hill", "wrapping_cosine", "fourier"}));
  }
  a.add("period", circuit.value(T, "s"));
  return a;
}

void add_chamber(Circuit& circuit, const Part& part, const char* type, Tree t) {
  t.add("activation", activation(circuit, part));
  t.add("initial_volume", start_volume(circuit, part.name + ".V", "Vc:" + part.name));
  circuit.block(part.name, type, std::move(t));
  circuit.internal(part, "Vc", circuit.units.volume, Expression::volume(part.name + ".V"));
}

void translate_linear(Circuit& circuit, const Part& part) {
  part.values.check_keys({"Emax", "Epass", "Vrest"});
  const auto& u = circuit.units;
  const double Epass = part.values.at("Epass").positive(), Emax = part.values.at("Emax").positive();
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part))).add("Emin", circuit.value(Epass, u.elastance));
  t.add("Emax", circuit.value(Epass + Emax, u.elastance));
  t.add("V0", circuit.value(part.values.at("Vrest").number(), u.volume));
  add_chamber(circuit, part, "elastance_chamber", std::move(t));
}

/// Between its two nodes, with the inertance of its outlet.
Tree with_outlet(const Circuit& circuit, const Part& part) {
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part))).add("to", Tree::scalar(circuit.outlet(part)));
  t.add("L", circuit.value(part.values.at("Impedance").positive(), circuit.units.inertance));
  return t;
}

void tell_flows(Circuit& circuit, const Part& part) {
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.flow_out(part, Expression::flow(part.name + ".q_out"));
}

void translate_inductive(Circuit& circuit, const Part& part) {
  part.values.check_keys({"Emax", "Emin", "Vrd", "Vrs", "Impedance"});
  const auto& u = circuit.units;
  Tree t = with_outlet(circuit, part);
  t.add("Emin", circuit.value(part.values.at("Emin").positive(), u.elastance));
  t.add("Emax", circuit.value(part.values.at("Emax").positive(), u.elastance));
  t.add("V0", circuit.value(part.values.at("Vrd").number(), u.volume));
  t.add("V0_systole", circuit.value(part.values.at("Vrs").number(), u.volume));
  add_chamber(circuit, part, "elastance_chamber", std::move(t));
  tell_flows(circuit, part);
}

void translate_exponential(Circuit& circuit, const Part& part) {
  part.values.check_keys({"Emax", "Kxp", "Kxv", "Vaso", "Impedance"});
  const auto& u = circuit.units;
  Tree t = with_outlet(circuit, part);
  t.add("Emax", circuit.value(part.values.at("Emax").positive(), u.elastance));
  t.add("P0", circuit.value(part.values.at("Kxp").positive(), u.pressure));
  t.add("k", circuit.value(part.values.at("Kxv").positive(), u.per_volume));
  t.add("V0", circuit.value(part.values.at("Vaso").number(), u.volume));
  add_chamber(circuit, part, "exponential_chamber", std::move(t));
  tell_flows(circuit, part);
}

/// Its parameters are SI by definition of the format.
void translate_sphere(Circuit& circuit, const Part& part) {
  if (circuit.units.name != "SI")
    part.node.error("a ChamberSphere is given in SI; import the model with --units SI");
  const std::pair<const char*, std::pair<const char*, const char*>> fields[] = {
      {"rho", {"rho", "kg/m3"}},
      {"thick0", {"d0", "m"}},
      {"radius0", {"r0", "m"}},
      {"W1", {"W1", "Pa"}},
      {"W2", {"W2", "Pa"}},
      {"eta", {"eta", "Pa.s"}},
      {"sigma_max", {"sigma_max", "Pa"}},
      {"alpha_max", {"alpha_max", "1/s"}},
      {"alpha_min", {"alpha_min", "1/s"}},
      {"tsys", {"t_systole", "s"}},
      {"tdias", {"t_diastole", "s"}},
      {"steepness", {"steepness", "s"}}};
  std::vector<std::string> keys;
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part)));
  for (const auto& [theirs, ours] : fields) {
    keys.push_back(theirs);
    t.add(ours.first, circuit.value(part.values.at(theirs).number(), ours.second));
  }
  part.values.check_keys(keys);
  t.add("period", circuit.value(circuit.source.period, "s"));
  const auto& n = part.name;
  const auto state = [&](const char* key, const Expression& e, const char* unknown, const char* unit) {
    t.add(key, circuit.start_value(e, circuit.from_file(std::string(unknown) + ":" + n, unit), unit));
  };
  const Expression r = Expression::of("l:" + n + ".r_m"), v = Expression::of("u:" + n + ".v_m_s"),
                   tau = Expression::pressure(n + ".tau"), V = Expression::volume(n + ".V");
  state("initial_displacement", r, "radius", "m");
  state("initial_velocity", v, "velo", "m/s");
  state("initial_active_stress", tau, "tau", "Pa");
  state("initial_volume", V, "volume", "m3");
  circuit.block(n, "sphere_chamber", std::move(t));
  circuit.internal(part, "radius", "m", r);
  circuit.internal(part, "velo", "m/s", v);
  circuit.internal(part, "stress", "Pa", Expression::pressure(n + ".S"));
  circuit.internal(part, "tau", "Pa", tau);
  circuit.internal(part, "volume", "m3", V);
}

}  // namespace

void translate_chamber(Circuit& circuit, const Part& part) {
  if (part.type == "ChamberSphere") return translate_sphere(circuit, part);
  if (part.type == "LinearElastanceChamber") return translate_linear(circuit, part);
  if (part.type == "ChamberElastanceInductor") return translate_inductive(circuit, part);
  translate_exponential(circuit, part);
}

void translate_valve(Circuit& circuit, const Part& part) {
  const auto& v = part.values;
  const auto& u = circuit.units;
  const bool smooth = part.type == "ValveTanh";
  std::vector<std::string> keys{"Rmax", "Rmin", "upstream_block", "downstream_block"};
  if (smooth) keys.push_back("Steepness");
  v.check_keys(keys);
  const double Rmin = smooth ? v.at("Rmin").non_negative() : v.at("Rmin").positive(),
               Rmax = v.at("Rmax").positive();
  if (!(Rmax > Rmin)) v.at("Rmax").error("must be larger than Rmin = {:g}, found {:g}", Rmin, Rmax);
  Tree t = Tree::map();
  t.add("from", Tree::scalar(circuit.inlet(part))).add("to", Tree::scalar(circuit.outlet(part)));
  t.add(smooth ? "Rmin" : "R", circuit.value(Rmin, u.resistance));
  t.add(smooth ? "Rmax" : "R_closed", circuit.value(Rmax, u.resistance));
  if (smooth) t.add("k", circuit.value(v.at("Steepness").positive(), u.per_pressure));
  circuit.block(part.name, smooth ? "smooth_valve" : "valve", std::move(t));
  circuit.flow_in(part, Expression::flow(part.name));
  circuit.flow_out(part, Expression::flow(part.name));
  if (smooth) circuit.internal(part, "valve_status", "", Expression::of("x:" + part.name + ".s"));
}

}  // namespace ostium::app::svzerod
