/// What an opening is told between two exchanges with whatever stands beyond it, and how it solves for its
/// pressure.
///
///   P(t) = p_star + slope (t - t0) + resistance (Q(t) - q_star)
///
///   t0          s         time of the last exchange
///   p_star      Pa        pressure at t0 for the flow q_star
///   slope       Pa/s      drift of that pressure for held flow
///   resistance  Pa.s/m3   answer of the pressure to the flow, >= 0 (a passive opening)
///   q_star      m3/s      reference flow, positive when leaving the vessel
///
/// Implicit port. The port pressure does work through the conjugate flow Q_c; a unit pressure held for dt
/// changes Q_c by -beta dt. With q_tilde the flow before the port's own kick, the law at the *new* flow reads
///   P = (P* + R (q_tilde - q_star)) / (1 + R beta dt),
/// which takes energy out for every R >= 0 and every dt (docs/theory/coupling.md).
///
/// Complementary filter. Q_c is the right fast signal but a biased mean; the counted volume flow Q_M is the
/// right mean but late. So the network is driven by Q_M and only the high-pass part of Q_c acts through the
/// resistance:
///   P = P* + R [F(Q_M) - F(Q_c) + Q_c - q_star],   dF(x)/dt = (x - F)/tau_f.
/// tau_f should be at least five times the delay of Q_M (exchange interval + way from the measuring plane to
/// the opening).
///
/// Not checked: the sign of `resistance`, the choice of tau_f (coupling/stability prints and checks both).
#pragma once
#include <cmath>

namespace ostium::sph3d {

struct PortLaw {
  double p_star = 0;      // Pa
  double slope = 0;       // Pa/s
  double resistance = 0;  // Pa.s/m3
  double q_star = 0;      // m3/s

  /// Pressure for the flow q, `since_exchange` seconds after t0.
  double pressure(double since_exchange, double q) const {
    return p_star + slope * since_exchange + resistance * (q - q_star);
  }

  /// The same law frozen at `since_exchange`: what an acoustic step solves with.
  PortLaw at(double since_exchange) const {
    return {p_star + slope * since_exchange, 0.0, resistance, q_star};
  }
};

/// Pressure of a port at its own new flow; the law must be frozen at the present time (PortLaw::at).
///   q_tilde  m3/s        conjugate flow before the port's kick
///   beta_dt  m3/(s.Pa)   loss of conjugate flow per unit of port pressure
inline double implicit_port_pressure(const PortLaw& law, double q_tilde, double beta_dt) {
  return (law.p_star + law.resistance * (q_tilde - law.q_star)) / (1.0 + law.resistance * beta_dt);
}

/// Plain state of the two low-pass filters F(Q_M), F(Q_c), m3/s.
struct ComplementaryFilter {
  double q_counted = 0;    // F(Q_M)
  double q_conjugate = 0;  // F(Q_c)

  /// Both filters at the flow of the start.
  static ComplementaryFilter started_at(double q) { return {q, q}; }

  /// The law with its flow replaced: what acts through the resistance is F(Q_M) + (Q_c - F(Q_c)).
  PortLaw corrected(PortLaw law) const {
    law.q_star -= q_counted - q_conjugate;
    return law;
  }

  /// Once per acoustic step, with the conjugate flow after the kick. Exact for a flow constant over dt.
  void step_conjugate(double q_c, double dt, double tau_f) { relax(q_conjugate, q_c, dt, tau_f); }

  /// Once per exchange, with the mean counted flow of the past window.
  void step_counted(double q_m, double window, double tau_f) { relax(q_counted, q_m, window, tau_f); }

 private:
  static void relax(double& f, double x, double dt, double tau_f) { f += (x - f) * -std::expm1(-dt / tau_f); }
};

}  // namespace ostium::sph3d
