/// Prescribed flow: a measured inflow, a pump. A missing end is the inexhaustible outside.
///
///   from o---( -> )---o to         0 = q - Q(t),   or at an opening of area A   0 = q - A V(t)
///
///   q          m3/s   flow from -> to (series q:NAME_m3_s)
///   flow       m3/s   Q(t), a waveform
///   velocity   m/s    V(t), mean velocity over the opening named by `to` or `from`; instead of `flow`
///
/// At an opening it prescribes the flow into the vessel, and the vessel's own pressure is the pressure there.
///
/// Example:
///   heart: {type: flow_source, flow: {fourier: {mean: 5, sin: [2]}, unit: L/min, period: 0.66 s}, to: AAo}
///
/// Source: definition. Not checked: that something can take the flow (network/graph does).
#pragma once
#include "core/waveform.hpp"
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct FlowSource : TwoTerminal {
  std::optional<Waveform> flow, velocity;

  static constexpr const char* type = "flow_source";
  static constexpr Nature nature = Nature::flow;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false}};

  template <class T>
  void equations(const In<FlowSource, T>& x, Out<FlowSource, T>& f) const {
    const T& q = x.y[0];
    f.own[0] = q - prescribed_flow(x.t);
    f.into = {q, -q};
  }
  double prescribed_flow(double t) const { return flow ? flow->value(t) : 0.0; }
  std::vector<double> kinks(double t0, double t1) const {
    return flow ? flow->kinks(t0, t1) : std::vector<double>();
  }
  bool needs_opening() const { return velocity.has_value() && !flow; }
  FlowSource at_opening(double area) const {
    FlowSource placed = *this;
    if (!needs_opening()) return placed;
    placed.flow = velocity->scaled(area);
    placed.velocity.reset();
    return placed;
  }
  std::vector<Terminal> terminals() const {
    if (flow.has_value() == velocity.has_value())
      user_error("needs one of `flow` and `velocity`, found {}", flow ? "both" : "none");
    return source_ends(*this);
  }
};

inline void declare(config::Fields<FlowSource>& f) {
  declare_ends(f);
  f.waveform("flow", &FlowSource::flow, "m3/s", "flow against time");
  f.waveform("velocity", &FlowSource::velocity, "m/s",
             "mean velocity at an opening against time, instead of `flow`");
}

}  // namespace ostium::lumped
