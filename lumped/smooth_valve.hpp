/// Heart valve whose resistance goes smoothly from open to closed: for models made elsewhere.
///
///   from o---[ R(p_from - p_to) ]---o to
///
///   q = (p_from - p_to)/(Rmin + (Rmax - Rmin) s),     s = (1 + tanh(k (p_to - p_from)))/2
///
///   q            m3/s      flow from -> to (series q:NAME_m3_s)
///   s            1         0 open, 1 closed (series x:NAME.s)
///   Rmin, Rmax   Pa.s/m3   resistance when open, >= 0, and when closed
///   k            1/Pa      steepness
///
/// It leaks and depends on k; `valve` does neither.
///
/// Example:
///   mitral: {type: smooth_valve, from: LA, to: LV, Rmin: 1e6 Pa.s/m3, Rmax: 1e9 Pa.s/m3, k: 1 1/mmHg}
///
/// Source: Pfaller et al., Biomech. Model. Mechanobiol. 18 (2019) 503, eq. 22. Not checked: that k resolves the
/// pressure differences.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct SmoothValve : TwoTerminal {
  double Rmin = 0, Rmax = 0, k = 0;
  std::optional<double> ground;

  static constexpr const char* type = "smooth_valve";
  static constexpr bool autonomous = true;
  static constexpr bool linear = false;
  static constexpr Nature nature = Nature::resistive;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"s", Quantity::ratio, false}};

  template <class T>
  void equations(const In<SmoothValve, T>& x, Out<SmoothValve, T>& f) const {
    const T &q = x.y[0], &s = x.y[1], drop = x.p[From] - x.p[To], closed = fermi(2 * k * drop);
    // solved for the flow: Newton's iteration sees one monotone curve instead of a product of two unknowns
    f.own[0] = q - drop / (Rmin + (Rmax - Rmin) * closed);
    f.own[1] = s - closed;
    f.into = {q, -q};
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }

 private:
  /// (1 - tanh(x/2))/2 without cancellation; it does not vanish, so that Rmin = 0 divides nothing by zero.
  template <class T>
  static T fermi(const T& x) {
    using std::exp;
    return 1.0 / (1.0 + exp(x < 600.0 ? x : T(600.0)));
  }
};

inline void declare(config::Fields<SmoothValve>& f) {
  declare_ends(f);
  f.quantity("Rmin", &SmoothValve::Rmin, "Pa.s/m3", "resistance when open").non_negative();
  f.quantity("Rmax", &SmoothValve::Rmax, "Pa.s/m3", "resistance when closed").positive();
  f.quantity("k", &SmoothValve::k, "1/Pa", "steepness").positive();
  f.quantity("ground", &SmoothValve::ground, "Pa", "fixed pressure of the end that is no node");
  f.check([](const SmoothValve& v) -> std::string {
    if (v.Rmin < v.Rmax) return {};
    return fmt::format("\"Rmin\" is {:g} Pa.s/m3 and must be smaller than \"Rmax\" = {:g} Pa.s/m3", v.Rmin,
                       v.Rmax);
  });
}

}  // namespace ostium::lumped
