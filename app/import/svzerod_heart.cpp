// The heart with lungs, taken apart into chambers, valves, lungs and the root of the aorta.
#include "app/import/svzerod_chambers.hpp"
#include "lumped/activation.hpp"

namespace ostium::app::svzerod {

using config::Tree;

namespace {

/// The heart with lungs: four chambers, four valves, the lungs, the root of the aorta.
class Heart {
 public:
  Heart(Circuit& circuit, const Part& part)
      : circuit_(circuit),
        part_(part),
        u_(circuit.units),
        inlet_(circuit.inlet(part)),
        outlet_(circuit.outlet(part)) {}

  void add() {
    check();
    atrium("RA", inlet_, "ra");
    ventricle("RV", "Erv_s", "Vrv_u");
    atrium("LA", "CLH.LA", "la");
    ventricle("LV", "Elv_s", "Vlv_u");
    valve("tricuspid", inlet_, "CLH.RV", "Rra_v", "Lra_v", "Q_RA");
    valve("pulmonary", "CLH.RV", "CLH.pul", "Rrv_a", "Lrv_a", "Q_RV");
    valve("mitral", "CLH.LA", "CLH.LV", "Rla_v", "Lla_v", "Q_LA");
    valve("aortic", "CLH.LV", outlet_, "Rlv_ao", "Llv_a", "Q_LV");
    lungs();
    aorta();
    tell();
  }

 private:
  double positive(const char* key) const { return part_.values.at(key).positive(); }

  void check() const {
    part_.values.check_keys({"Tsa",    "tpwave", "Erv_s",   "Elv_s",   "iml",     "imr",    "Lra_v",
                             "Rra_v",  "Lrv_a",  "Rrv_a",   "Lla_v",   "Rla_v",   "Llv_a",  "Rlv_ao",
                             "Vrv_u",  "Vlv_u",  "Rpd",     "Cp",      "Cpa",     "Kxp_ra", "Kxv_ra",
                             "Kxp_la", "Kxv_la", "Emax_ra", "Emax_la", "Vaso_ra", "Vaso_la"});
    for (const char* key : {"iml", "imr"}) part_.values.at(key).number();
  }

  Tree initial_volume(const std::string& chamber) const {
    return start_volume(circuit_, "CLH." + chamber + ".V", "V_" + chamber + ":CLH");
  }

  void atrium(const std::string& name, const std::string& node, const std::string& side) {
    const double T = circuit_.source.period;
    Tree kick = activation_of("wrapping_cosine").add("end", circuit_.value(T / positive("tpwave"), "s"));
    kick.add("duration", circuit_.value(T * positive("Tsa"), "s")).add("period", circuit_.value(T, "s"));
    Tree t = Tree::map();
    t.add("from", Tree::scalar(node))
        .add("Emax", circuit_.value(positive(("Emax_" + side).c_str()), u_.elastance));
    t.add("P0", circuit_.value(positive(("Kxp_" + side).c_str()), u_.pressure));
    t.add("k", circuit_.value(positive(("Kxv_" + side).c_str()), u_.per_volume));
    t.add("V0", circuit_.value(part_.values.at("Vaso_" + side).number(), u_.volume));
    t.add("activation", std::move(kick)).add("initial_volume", initial_volume(name));
    circuit_.block("CLH." + name, "exponential_chamber", std::move(t));
  }

  /// That program scales the normalised curve as it is, ours runs from 0 to 1.
  void ventricle(const std::string& name, const char* E, const char* V0) {
    const auto [low, high] = lumped::ventricular_range();
    Tree beat = activation_of("ventricle").add("period", circuit_.value(circuit_.source.period, "s"));
    Tree t = Tree::map();
    t.add("from", Tree::scalar("CLH." + name)).add("Emin", circuit_.value(low * positive(E), u_.elastance));
    t.add("Emax", circuit_.value(high * positive(E), u_.elastance));
    t.add("V0", circuit_.value(part_.values.at(V0).number(), u_.volume));
    t.add("activation", std::move(beat)).add("initial_volume", initial_volume(name));
    circuit_.block("CLH." + name, "elastance_chamber", std::move(t));
  }

  void valve(const std::string& name, const std::string& from, const std::string& to, const char* R,
             const char* L, const std::string& flow) {
    Tree t = Tree::map();
    t.add("from", Tree::scalar(from)).add("to", Tree::scalar(to));
    t.add("R", circuit_.value(part_.values.at(R).non_negative(), u_.resistance));
    t.add("L", circuit_.value(positive(L), u_.inertance));
    t.add("initial_flow",
          circuit_.start_value(Expression::flow("CLH." + name),
                               std::max(0.0, circuit_.from_file(flow + ":CLH", u_.flow)), u_.flow));
    circuit_.block("CLH." + name, "valve", std::move(t));
  }

  void lungs() {
    Tree t = Tree::map();
    t.add("from", Tree::scalar("CLH.pul")).add("to", Tree::scalar("CLH.LA"));
    t.add("R", circuit_.value(positive("Rpd"), u_.resistance))
        .add("C", circuit_.value(positive("Cp"), u_.compliance));
    t.add("stores", Tree::scalar("false"));
    t.add("initial_pressure",
          circuit_.start_value(Expression::pressure("CLH.lungs.u"),
                               circuit_.from_file("P_pul:CLH", u_.pressure), u_.pressure));
    circuit_.block("CLH.lungs", "rc", std::move(t));
  }

  void aorta() {
    Tree t = Tree::map();
    t.add("from", Tree::scalar(outlet_)).add("C", circuit_.value(positive("Cpa"), u_.compliance));
    const std::string unknown = "pressure:" + circuit_.source.connections[part_.out[0]].name;
    t.add("initial_pressure", circuit_.start_value(Expression::pressure("CLH.aorta.u"),
                                                   circuit_.from_file(unknown, u_.pressure), u_.pressure));
    circuit_.block("CLH.aorta", "capacitor", std::move(t));
  }

  void tell() {
    circuit_.flow_in(part_, Expression::flow("CLH.RA") + Expression::flow("CLH.tricuspid"));
    circuit_.flow_out(part_, Expression::flow("CLH.aortic") - Expression::flow("CLH.aorta"));
    const auto p = [&](const char* variable, const char* node) {
      circuit_.internal(part_, variable, u_.pressure, Expression::pressure(std::string("CLH.") + node));
    };
    const auto V = [&](const std::string& c) {
      circuit_.internal(part_, "V_" + c, u_.volume, Expression::volume("CLH." + c + ".V"));
    };
    const auto q = [&](const char* variable, const char* valve) {
      circuit_.internal(part_, variable, u_.flow, Expression::flow(std::string("CLH.") + valve));
    };
    V("RA"), q("Q_RA", "tricuspid"), p("P_RV", "RV"), V("RV"), q("Q_RV", "pulmonary"), p("P_pul", "pul");
    p("P_LA", "LA"), V("LA"), q("Q_LA", "mitral"), p("P_LV", "LV"), V("LV"), q("Q_LV", "aortic");
  }

  Circuit& circuit_;
  const Part& part_;
  const UnitSystem& u_;
  std::string inlet_, outlet_;
};

}  // namespace

void translate_heart(Circuit& circuit, const Part& part) { Heart(circuit, part).add(); }

}  // namespace ostium::app::svzerod
