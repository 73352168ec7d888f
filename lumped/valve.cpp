#include "lumped/valve.hpp"

namespace ostium::lumped {

namespace {

std::string check_valve(const Valve& v) {
  if (v.R == 0 && v.L == 0)
    return "an open valve needs a resistance \"R\" or an inertance \"L\" > 0; without both it would short "
           "its two nodes";
  if (v.R_closed && *v.R_closed <= v.R)
    return fmt::format(
        "\"R_closed\" is {:g} Pa.s/m3 and must be larger than \"R\" = {:g} Pa.s/m3; without it the closed "
        "valve is tight",
        *v.R_closed, v.R);
  if (v.initial_flow < 0 && !v.R_closed)
    return fmt::format(
        "\"initial_flow\" is {:g} m3/s, and a tight valve lets nothing flow back; it must be >= 0 m3/s",
        v.initial_flow);
  return {};
}

}  // namespace

void declare(config::Fields<Valve>& f) {
  declare_ends(f);
  f.quantity("R", &Valve::R, "Pa.s/m3", "resistance when open").non_negative();
  f.quantity("L", &Valve::L, "Pa.s2/m3", "inertance; 0: none").non_negative().or_else(0.0);
  f.quantity("R_closed", &Valve::R_closed, "Pa.s/m3", "resistance of the leak when closed; without it tight")
      .positive();
  f.quantity("ground", &Valve::ground, "Pa", "fixed pressure of the end that is no node");
  f.quantity("initial_flow", &Valve::initial_flow, "m3/s", "flow through the inertance at the start")
      .or_else(0.0);
  f.check(check_valve);
}

}  // namespace ostium::lumped
