#include "lumped/vessel.hpp"

namespace ostium::lumped {

/// An element that is left out passes its neighbour on to the node.
std::vector<Branch> Vessel::branches() const {
  const Nature loss = R != 0 || K != 0 ? Nature::resistive : Nature::pressure;
  const Nature series = L > 0 ? Nature::inductive : loss;
  if (C == 0) return {{From, To, series}};
  if (order == Order::CRL) return {{From, lumped::ground, Nature::capacitive}, {From, To, series}};
  if (L == 0) return {{From, To, loss}, {To, lumped::ground, Nature::capacitive}};
  const Nature entry = loss == Nature::resistive ? loss : Nature::capacitive;
  return {{From, lumped::ground, entry}, {To, lumped::ground, Nature::inductive}};
}

namespace {

std::string check_vessel(const Vessel& v) {
  if (v.fitted || (v.R >= 0 && v.K >= 0)) return {};
  return fmt::format(
      "{} is {:g} {}, and a loss must be >= 0; correct it, or where it comes from a fit write \"fitted: "
      "true\"",
      v.R < 0 ? "R" : "K", v.R < 0 ? v.R : v.K, v.R < 0 ? "Pa.s/m3" : "Pa.s2/m6");
}

}  // namespace

void declare(config::Fields<Vessel>& f) {
  declare_ends(f);
  f.quantity("R", &Vessel::R, "Pa.s/m3", "resistance");
  f.quantity("C", &Vessel::C, "m3/Pa", "compliance; 0: none").non_negative().or_else(0.0);
  f.quantity("L", &Vessel::L, "Pa.s2/m3", "inertance; 0: none").non_negative().or_else(0.0);
  f.quantity("K", &Vessel::K, "Pa.s2/m6", "loss with the square of the flow: stenosis").or_else(0.0);
  f.choice("order", &Vessel::order, {{"RCL", Order::RCL}, {"CRL", Order::CRL}},
           "RCL: the compliance behind the loss, CRL: at the inlet")
      .or_else(Order::RCL);
  f.quantity("ground", &Vessel::ground, "Pa", "fixed pressure of the end that is no node");
  f.quantity("initial_pressure", &Vessel::initial_pressure, "Pa", "pressure on the compliance at the start")
      .or_else(0.0);
  f.quantity("initial_flow", &Vessel::initial_flow, "m3/s", "flow through the inertance at the start")
      .or_else(0.0);
  f.flag("fitted", &Vessel::fitted, "the values come from a fit: R and K may be negative").or_else(false);
  f.check(check_vessel);
}

}  // namespace ostium::lumped
