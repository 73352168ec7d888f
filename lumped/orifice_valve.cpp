#include "lumped/orifice_valve.hpp"

namespace ostium::lumped {

namespace {

std::string check_orifice(const OrificeValve& v) {
  if (v.A_closed < v.A_open) return {};
  return fmt::format("\"A_closed\" is {:g} m2 and must be smaller than \"A_open\" = {:g} m2", v.A_closed,
                     v.A_open);
}

}  // namespace

void declare(config::Fields<OrificeValve>& f) {
  using V = OrificeValve;
  declare_ends(f);
  f.quantity("A_open", &V::A_open, "m2", "effective area when open").positive();
  f.quantity("A_closed", &V::A_closed, "m2", "effective area of the leak when closed").positive();
  f.quantity("l", &V::l, "m", "length of the accelerated column").positive();
  f.quantity("rho", &V::rho, "kg/m3", "density of blood").positive().or_else(1060);
  f.quantity("K_open", &V::K_open, "1/(Pa.s)", "rate of opening").positive();
  f.quantity("K_close", &V::K_close, "1/(Pa.s)", "rate of closing").positive();
  f.quantity("R", &V::R, "Pa.s/m3", "viscous resistance").non_negative().or_else(0.0);
  f.quantity("ground", &V::ground, "Pa", "fixed pressure of the end that is no node");
  f.quantity("initial_flow", &V::initial_flow, "m3/s", "flow at the start").or_else(0.0);
  f.number("initial_opening", &V::initial_opening, "z at the start").at_least(0).at_most(1).or_else(0.0);
  f.check(check_orifice);
}

}  // namespace ostium::lumped
