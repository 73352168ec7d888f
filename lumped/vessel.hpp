/// Segment of a vessel: viscous loss, loss of a stenosis, compliance and inertance.
///
///   order RCL (default)                          order CRL
///                      u                           u
///   from o---[ R + K|q| ]---o---( L )---o to       from o---[ R + K|q_out| ]---( L )---o to
///                           |                           |
///                          === C                       === C
///                           |                           |
///                        ambient                     ambient
///
///   RCL   0 = p_from - u - (R + K|q|) q       C du/dt = q - q_out     L dq_out/dt = u - p_to
///   CRL   0 = p_from - u                      C du/dt = q - q_out     L dq_out/dt = u - p_to - (R + K|q_out|) q_out
///
///   q, q_out   m3/s        flow in at `from`, out at `to` (series q:NAME_m3_s, q:NAME.q_out_m3_s); q_out a state if L > 0
///   u          Pa          pressure on the compliance (series p:NAME.u_Pa), a state if C > 0
///   R          Pa.s/m3     resistance, >= 0 (Poiseuille: 8 mu length/(pi r^4))
///   C, L       m3/Pa, Pa.s2/m3   compliance and inertance, >= 0; 0 leaves the element out
///   K          Pa.s2/m6    loss that grows with the square of the flow: stenosis, branch of a junction
///
/// Without C it is the loss of a branch: R, K and L in series. `fitted: true` lets R and K be negative, as fits of
/// measured pressures make them.
///
/// Example:
///   lad: {type: vessel, from: AAo, to: LAD, R: 2e7 Pa.s/m3, C: 1e-11 m3/Pa, L: 1e5 Pa.s2/m3, K: 4e12
///       Pa.s2/m6}
///
/// Source: Formaggia, Quarteroni & Veneziani 2009, ch. 10; stenosis: Young & Tsai, J. Biomech. 6 (1973) 395. Not
/// checked: that the values fit a geometry.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

enum class Order { RCL, CRL };

struct Vessel : TwoTerminal {
  double R = 0, C = 0, L = 0, K = 0;
  Order order = Order::RCL;
  double initial_pressure = 0, initial_flow = 0;
  std::optional<double> ground;
  bool fitted = false;

  static constexpr const char* type = "vessel";
  static constexpr bool autonomous = true;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"q_out", Quantity::flow, false},
                                       Unknown{"u", Quantity::pressure, false}};

  template <class T>
  void equations(const In<Vessel, T>& x, Out<Vessel, T>& f) const {
    const T &q = x.y[0], &q_out = x.y[1], &u = x.y[2], &dq_out = x.dy[1], &du = x.dy[2];
    const bool early = order == Order::RCL;
    f.own[0] = x.p[From] - u - (early ? loss(q) : T(0));
    f.own[1] = L * dq_out - (u - x.p[To] - (early ? T(0) : loss(q_out)));
    f.own[2] = C * du - (q - q_out);
    f.into = {q, -q_out};
  }
  std::array<Unknown, 3> present_unknowns() const {
    auto all = unknowns;
    all[1].differential = L > 0;
    all[2].differential = C > 0;
    return all;
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }
  std::vector<Branch> branches() const;
  void initial(double* y) const { y[0] = y[1] = initial_flow, y[2] = initial_pressure; }
  double compliance() const { return C; }
  bool linear() const { return K == 0; }

 private:
  template <class T>
  T loss(const T& q) const {
    using std::abs;
    return (R + K * abs(q)) * q;
  }
};

void declare(config::Fields<Vessel>& f);

}  // namespace ostium::lumped
