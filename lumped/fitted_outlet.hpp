/// What the outlets given by an impedance share: a rational impedance in front of a distal pressure.
///
///   from o---[ Z(s) ]---o Pd
///
///   p_from - Pd = D q + sum_k a_k y_k                 (lumped/impedance_fit)
///   first order:    tau dy/dt + y = q
///   second order:   (tau/d) dy/dt = q - y - z,   d tau dz/dt = y
///
///   q        m3/s   flow entering at `from` (series q:NAME_m3_s)
///   y, z     m3/s   states x1, x2, .. (series q:NAME.x1_m3_s, ..); those that the fit does not need are q or 0
///   Pd       Pa     distal pressure (default 0)
///
/// Not checked: what the fit says of its error.
#pragma once
#include <algorithm>
#include <vector>

#include "lumped/element.hpp"
#include "lumped/impedance_fit.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct FittedOutlet {
  static constexpr int ports = 1;
  static constexpr int most_states = 12;
  Name from;
  double Pd = 0;
  RationalImpedance Z;

  static constexpr Nature nature = Nature::resistive;
  static constexpr auto state = [](const char* name) { return Unknown{name, Quantity::flow, true}; };
  static constexpr std::array<Unknown, 1 + most_states> unknowns{Unknown{"q", Quantity::flow, false},
                                                                 state("x1"),
                                                                 state("x2"),
                                                                 state("x3"),
                                                                 state("x4"),
                                                                 state("x5"),
                                                                 state("x6"),
                                                                 state("x7"),
                                                                 state("x8"),
                                                                 state("x9"),
                                                                 state("x10"),
                                                                 state("x11"),
                                                                 state("x12")};

  template <class B, class T>
  void outlet(const In<B, T>& x, Out<B, T>& f) const {
    const T& q = x.y[0];
    T drop = Z.D * q;
    std::size_t k = 1;
    for (const auto& [a, tau, d] : Z.terms) {
      const T& y = x.y[k];
      drop += a * y;
      if (d > 0) {
        f.own[k] = tau / d * x.dy[k] - (q - y - x.y[k + 1]);
        f.own[k + 1] = d * tau * x.dy[k + 1] - y;
      } else {
        f.own[k] = tau * x.dy[k] + y - q;
      }
      k += d > 0 ? 2 : 1;
    }
    for (; k < unknowns.size(); ++k) f.own[k] = x.y[k];
    f.own[0] = x.p[0] - Pd - drop;
    f.into = {q};
  }

  std::array<Unknown, 1 + most_states> present_unknowns() const {
    auto all = unknowns;
    for (std::size_t k = 1 + states(); k < all.size(); ++k) all[k].differential = false;
    return all;
  }
  /// What the fit follows from moves its terms, and some of them come and go.
  bool smooth_in(const std::string& parameter) const { return parameter == "Pd"; }
  std::vector<Terminal> terminals() const;
  std::vector<Branch> branches() const { return {{0, lumped::ground, Nature::resistive}}; }

 protected:
  std::size_t states() const {
    std::size_t n = 0;
    for (const auto& term : Z.terms) n += term.damping > 0 ? 2 : 1;
    return n;
  }
  void fit(const std::vector<ImpedanceSample>& samples);
};

template <class B>
void declare_outlet(config::Fields<B>& f) {
  f.text("from", static_cast<Name B::*>(&B::from), "node its flow comes from");
  f.quantity("Pd", static_cast<double B::*>(&B::Pd), "Pa", "distal pressure").or_else(0.0);
}

}  // namespace ostium::lumped
