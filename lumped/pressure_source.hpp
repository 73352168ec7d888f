/// Prescribed pressure: a reservoir, a measured pressure, the simplest outlet.
///
///   ( P )---o to                   0 = p_to - P(t)             flow positive into the node
///   from o---( P )                 0 = p_from - P(t)           flow positive out of the node
///   from o---( P )---o to          0 = p_to - p_from - P(t)    a pump of pressure rise P
///
///   q         m3/s   flow from -> to (series q:NAME_m3_s)
///   pressure  Pa     P(t), a waveform
///
/// Example:
///   atrium: {type: pressure_source, from: vein, pressure: 5 mmHg}
///
/// Source: definition. Not checked: two of them at one node (network/graph does).
#pragma once
#include "core/waveform.hpp"
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct PressureSource : TwoTerminal {
  Waveform pressure;

  static constexpr const char* type = "pressure_source";
  static constexpr Nature nature = Nature::pressure;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false}};

  template <class T>
  void equations(const In<PressureSource, T>& x, Out<PressureSource, T>& f) const {
    const T& q = x.y[0];
    f.own[0] = (to ? x.p[To] - x.p[From] : x.p[From]) - pressure.value(x.t);
    f.into = {q, -q};
  }
  std::vector<double> kinks(double t0, double t1) const { return pressure.kinks(t0, t1); }
  std::vector<Terminal> terminals() const { return source_ends(*this); }
};

inline void declare(config::Fields<PressureSource>& f) {
  declare_ends(f);
  f.waveform("pressure", &PressureSource::pressure, "Pa", "pressure against time");
}

}  // namespace ostium::lumped
