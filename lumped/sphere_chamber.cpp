#include "lumped/sphere_chamber.hpp"

namespace ostium::lumped {

std::vector<Terminal> SphereChamber::terminals() const {
  if (!from) user_error("has no `from`; name the node the chamber is at");
  if (from->empty()) user_error("has a node without a name; write for example `from: LV`");
  return {{"from", *from, 0}};
}

double SphereChamber::rate(double t) const {
  double s = std::fmod(t, period);
  if (s < 0) s += period;
  const double on = 1 + std::tanh((s - t_systole) / steepness),
               off = 1 - std::tanh((s - t_diastole) / steepness);
  const double f = 0.25 * on * off;
  return alpha_max * f + alpha_min * (1 - f);
}

/// Where |a| and max(a, 0) have corners: the zeros of a, one at each flank of f, and the begin of a beat.
std::vector<double> SphereChamber::kinks(double t0, double t1) const {
  const double f = -alpha_min / (alpha_max - alpha_min);  // there a = 0
  const double from_middle = 0.5 * steepness * std::log(f / (1 - f));
  std::vector<double> all;
  for (double corner : {0.0, t_systole + from_middle, t_diastole - from_middle})
    for (double n = std::floor((t0 - corner) / period); corner + n * period < t1; ++n)
      if (corner + n * period > t0) all.push_back(corner + n * period);
  return all;
}

namespace {

std::string check_sphere(const SphereChamber& s) {
  if (s.t_systole < s.t_diastole && s.t_diastole < s.period) return {};
  return fmt::format(
      "the times t_systole = {:g} s, t_diastole = {:g} s and period = {:g} s must grow in this order; a beat "
      "contracts "
      "first and relaxes before it ends",
      s.t_systole, s.t_diastole, s.period);
}

}  // namespace

void declare(config::Fields<SphereChamber>& f) {
  using S = SphereChamber;
  f.text("from", &S::from, "node the chamber is at");
  f.quantity("rho", &S::rho, "kg/m3", "density of the wall").positive();
  f.quantity("d0", &S::d0, "m", "thickness of the wall").positive();
  f.quantity("r0", &S::r0, "m", "radius at rest").positive();
  f.quantity("W1", &S::W1, "Pa", "first stiffness of the tissue").positive();
  f.quantity("W2", &S::W2, "Pa", "second stiffness of the tissue").non_negative();
  f.quantity("eta", &S::eta, "Pa.s", "viscosity of the tissue").non_negative();
  f.quantity("sigma_max", &S::sigma_max, "Pa", "largest active stress").non_negative();
  f.quantity("alpha_max", &S::alpha_max, "1/s", "rate of activation").positive();
  f.quantity("alpha_min", &S::alpha_min, "1/s", "rate of relaxation, negative").below(0);
  f.quantity("t_systole", &S::t_systole, "s", "begin of the activation in the beat").non_negative();
  f.quantity("t_diastole", &S::t_diastole, "s", "end of the activation in the beat").positive();
  f.quantity("steepness", &S::steepness, "s", "duration of either switch").positive();
  f.quantity("period", &S::period, "s", "period of the beat").positive();
  f.quantity("initial_displacement", &S::initial_displacement, "m", "r at the start").or_else(0.0);
  f.quantity("initial_velocity", &S::initial_velocity, "m/s", "v at the start").or_else(0.0);
  f.quantity("initial_active_stress", &S::initial_active_stress, "Pa", "tau at the start").or_else(0.0);
  f.quantity("initial_volume", &S::initial_volume, "m3", "V at the start; if not given that of the sphere")
      .non_negative();
  f.check(check_sphere);
}

}  // namespace ostium::lumped
