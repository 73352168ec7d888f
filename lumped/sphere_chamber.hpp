/// Heart chamber as a thin sphere of muscle: elastic, viscous, contracting.
///
///   from o---+
///            |
///          sphere of radius r0 + r, wall of thickness d0
///
///   l = 1 + r/r0,  c = l^2
///   rho d0 dv/dt + (d0/r0) l S - p c = 0,     dr/dt = v,     dV/dt = 4 pi r0^2 c v = q
///   S = tau + 4 (1 - c^-3)(W1 + c W2) + 2 eta l (v/r0)(1 + 2 c^-6)
///   dtau/dt + |a| tau = sigma_max max(a, 0),
///   a = alpha_max f + alpha_min (1 - f),   f = (1 + tanh((s - t_systole)/g)) (1 - tanh((s - t_diastole)/g))/4,  s = t mod T
///
///   q              m3/s     flow into the chamber (series q:NAME_m3_s)
///   r, v           m, m/s   displacement and velocity of the wall, states (series l:NAME.r_m, u:NAME.v_m_s)
///   tau            Pa       active stress, a state (series p:NAME.tau_Pa)
///   S              Pa       stress of the wall (series p:NAME.S_Pa)
///   V              m3       volume, a state: starts at initial_volume, else that of the sphere of radius r0
///   rho, d0, r0    kg/m3, m, m    density of the wall, its thickness, radius at rest
///   W1, W2         Pa       stiffness of the tissue;  eta  Pa.s  its viscosity
///   sigma_max      Pa       largest active stress
///   alpha_max, alpha_min    1/s   rates of activation (> 0) and of relaxation (< 0)
///   t_systole, t_diastole, steepness (g), period (T)   s   begin, end and sharpness of the activation
///
/// Example:
///   lv: {type: sphere_chamber, from: LV, rho: 1000 kg/m3, d0: 10 mm, r0: 50 mm, W1: 10 kPa, W2: 40 Pa, eta:
///       10 Pa.s, sigma_max: 185 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.17 s, t_diastole:
///       0.484 s, steepness: 0.005 s, period: 1 s}
///
/// Source: Caruel et al., Biomech. Model. Mechanobiol. 13 (2014) 897, eq. 13; activation: Pfaller et al., Biomech. Model.
/// Mechanobiol. 18 (2019) 503. Not checked: that the wall is thin.
#pragma once
#include "core/vec.hpp"
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct SphereChamber {
  static constexpr int ports = 1;
  enum Port { From };
  Name from;
  double rho = 0, d0 = 0, r0 = 0, W1 = 0, W2 = 0, eta = 0, sigma_max = 0, alpha_max = 0, alpha_min = 0;
  double t_systole = 0, t_diastole = 0, steepness = 0, period = 0;
  double initial_displacement = 0, initial_velocity = 0, initial_active_stress = 0;
  std::optional<double> initial_volume;

  static constexpr const char* type = "sphere_chamber";
  static constexpr bool linear = false;
  static constexpr std::array unknowns{
      Unknown{"q", Quantity::flow, false},      Unknown{"r", Quantity::length, true},
      Unknown{"v", Quantity::velocity, true},   Unknown{"S", Quantity::pressure, false},
      Unknown{"tau", Quantity::pressure, true}, Unknown{"V", Quantity::volume, true}};

  template <class T>
  void equations(const In<SphereChamber, T>& x, Out<SphereChamber, T>& f) const {
    const auto& [q, r, v, S, tau, V] = x.y;
    const auto& [dq, dr, dv, dS, dtau, dV] = x.dy;
    const T l = 1.0 + r / r0, c = l * l, c3 = 1.0 / (c * c * c);
    const double a = rate(x.t);
    f.own[0] = rho * d0 * dv + d0 / r0 * l * S - x.p[From] * c;
    f.own[1] = dr - v;
    f.own[2] = dV - 4 * pi * r0 * r0 * c * v;
    f.own[3] = S - (tau + 4.0 * (1.0 - c3) * (W1 + W2 * c) + 2 * eta * l * (v / r0) * (1.0 + 2.0 * c3 * c3));
    f.own[4] = dtau + std::abs(a) * tau - sigma_max * std::max(a, 0.0);
    f.own[5] = q - 4 * pi * r0 * r0 * c * v;
    f.into = {q};
  }
  std::vector<Terminal> terminals() const;
  std::vector<Branch> branches() const { return {{From, lumped::ground, Nature::inductive}}; }
  void initial(double* y) const {
    y[1] = initial_displacement, y[2] = initial_velocity, y[4] = initial_active_stress;
    y[5] = initial_volume.value_or(4.0 / 3 * pi * std::pow(r0 + initial_displacement, 3));
  }
  /// 1/s, rate of activation a(t).
  double rate(double t) const;
  std::vector<double> kinks(double t0, double t1) const;
};

void declare(config::Fields<SphereChamber>& f);

}  // namespace ostium::lumped
