/// Ends of a heart chamber: a node it fills from and empties into, or an outlet of its own behind an inertance.
///
///   from o---+                 from o---+---( L )---o to
///            |                          |
///          chamber                   chamber
///
///   0 = dV/dt - (q - q_out),    L dq_out/dt = p_from - p_to   (without `to`: q_out = 0)
///
/// Valves on both sides are blocks that end at the same node. Not checked: that V stays positive.
#pragma once
#include "lumped/activation.hpp"
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct ChamberEnds : TwoTerminal {
  double L = 0;
  Activation activation;
  std::optional<double> initial_volume;

  enum Own { q, q_out, V };
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"q_out", Quantity::flow, false},
                                       Unknown{"V", Quantity::volume, true}};
  static constexpr bool linear = false;  // the elastance changes in time

  /// The equations of the chamber whose muscle answers the volume with the pressure P.
  template <class B, class T>
  void chamber(const In<B, T>& x, const T& P, Out<B, T>& f) const {
    f.own[0] = x.p[From] - P;
    f.own[1] = to ? L * x.dy[q_out] - (x.p[From] - x.p[To]) : x.y[q_out];
    f.own[2] = x.dy[V] - (x.y[q] - x.y[q_out]);
    f.into = {x.y[q], -x.y[q_out]};
  }
  void prepare() { activation.prepare(); }
  std::array<Unknown, 3> present_unknowns() const {
    auto all = unknowns;
    all[q_out].differential = to.has_value();
    return all;
  }
  std::vector<Terminal> terminals() const;
  std::vector<Branch> branches() const;
  std::vector<double> kinks(double t0, double t1) const { return activation.kinks(t0, t1); }
};

template <class B>
void declare_chamber(config::Fields<B>& f) {
  f.text("from", static_cast<Name B::*>(&B::from), "node the chamber is at");
  f.text("to", static_cast<Name B::*>(&B::to),
         "node behind the inertance L; without it the chamber empties into `from`");
  f.quantity("L", static_cast<double B::*>(&B::L), "Pa.s2/m3", "inertance of the outlet, with `to`")
      .non_negative()
      .or_else(0.0);
  f.section("activation", static_cast<Activation B::*>(&B::activation), "course of the contraction");
  f.quantity("initial_volume", static_cast<std::optional<double> B::*>(&B::initial_volume), "m3",
             "volume at the start; if not given the unstressed one")
      .non_negative();
}

}  // namespace ostium::lumped
