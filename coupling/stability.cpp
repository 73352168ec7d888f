#include "coupling/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"

namespace ostium::coupling {

using network::PortKind;

namespace {

PortNumbers port_numbers(const network::Network& n, int k, const VesselNumbers& v,
                         const Eigen::MatrixXd& instant, const Eigen::MatrixXd& window, double omega1) {
  const double area = n.port(k).area;
  return {.opening = n.port(k).opening,
          .Zc = v.density * v.sound_speed / area,
          .R_instant = instant(k, k),
          .R_window = window(k, k),
          .inertance = v.density * v.length / area,
          .Z1 = std::abs(n.impedance(k, omega1))};
}

/// Largest R over Z_c, least window over R C_f.
struct Margins {
  double fast, compliant;
};
constexpr double fast_window = 0.02, slow_window = 3;  // of the transit time
constexpr double weak = 0.05;                          // of Z_c: harmless at any window

/// Of the explicit schemes; none for the implicit one.
std::optional<Margins> margins(SchemeKind scheme) {
  switch (scheme) {
    case SchemeKind::linearised:
      return std::nullopt;
    case SchemeKind::extrapolated:
      return Margins{0.5, 20};
    default:
      return Margins{1, 5};
  }
}

/// A long window lets the vessel settle at a new volume before the next exchange.
bool settles(const StabilityNumbers& s, const Margins& m) {
  const double tau = s.exchange.window;
  return s.prescribed_inflow && tau >= slow_window * s.transit &&
         tau >= m.compliant * s.R_parallel * s.fluid_compliance;
}

double most(const StabilityNumbers& s, const PortNumbers& p, const Margins& m) {
  const double tau = s.exchange.window;
  if (tau <= fast_window * s.transit) return m.fast * p.Zc;
  if (s.prescribed_inflow) return weak * p.Zc;
  return std::max(weak * p.Zc, 0.5 * m.fast * std::min(p.Zc, p.inertance / tau));
}

/// The sentence that says what is wrong with an explicit exchange; empty if nothing is.
std::string objection(const StabilityNumbers& s, const Margins& m) {
  if (settles(s, m)) return "";
  for (const auto& p : s.ports) {
    if (p.R_window < most(s, p, m)) continue;
    std::string text = fmt::format(
        "the network answers at \"{}\" with R = {:.3g} Pa.s/m3; with an exchange every {:.3g} ms it must be "
        "below {:.3g} "
        "Pa.s/m3 (the vessel's own impedance there is {:.3g})",
        p.opening, p.R_window, 1e3 * s.exchange.window, most(s, p, m), p.Zc);
    const double least = std::max(slow_window * s.transit, m.compliant * s.R_parallel * s.fluid_compliance);
    if (s.prescribed_inflow) text += fmt::format(", or the exchanges at least {:.3g} ms apart", 1e3 * least);
    return text;
  }
  return "";
}

std::string filter_objection(const ExchangeNumbers& x) {
  if (x.filter_time <= 0 || x.filter_time >= 5 * (x.window + x.delay)) return "";
  return fmt::format(
      "the filter time of the ports, {:.3g} ms, should be at least five times the delay of the counted flow, "
      "{:.3g} ms",
      1e3 * x.filter_time, 5e3 * (x.window + x.delay));
}

}  // namespace

StabilityNumbers stability_numbers(const network::Network& n, const VesselNumbers& v,
                                   const ExchangeNumbers& exchange, double omega1) {
  StabilityNumbers s;
  s.exchange = exchange;
  s.fluid_compliance = v.volume / (v.density * v.sound_speed * v.sound_speed) + v.wall_compliance;
  s.network_compliance = n.total_compliance();
  s.transit = v.length / v.sound_speed;
  const Eigen::MatrixXd instant = n.instant_resistance(), window = n.port_resistance(exchange.window);
  double conductance = 0;
  for (int k = 0; k < n.port_count(); ++k) {
    if (n.kind(k) == PortKind::flow) {
      s.prescribed_inflow = true;
      continue;
    }
    s.ports.push_back(port_numbers(n, k, v, instant, window, omega1));
    conductance += 1 / std::max(s.ports.back().R_window, 1e-30);
  }
  s.R_parallel = conductance > 0 ? 1 / conductance : 0;
  return s;
}

std::string StabilityNumbers::text() const {
  std::string lines = fmt::format(
      "Exchange every {:.3g} ms; transit time of the vessel {:.3g} ms\n"
      "Storage of the fluid {:.3g} m3/Pa, compliance of the network {:.3g} m3/Pa ({:.0f} % of it is the "
      "fluid's)\n",
      1e3 * exchange.window, 1e3 * transit, fluid_compliance, network_compliance,
      network_compliance > 0 ? 100 * fluid_compliance / network_compliance : 0.0);
  for (const auto& p : ports)
    lines += fmt::format("  {:<12} R/Zc {:8.3g}   R {:9.3g}   Zc {:9.3g}   |Z(heart)| {:9.3g} Pa.s/m3\n",
                         p.opening, p.R_instant / p.Zc, p.R_instant, p.Zc, p.Z1);
  return lines;
}

std::vector<std::string> check_stability(const StabilityNumbers& s, SchemeKind scheme, bool force) {
  std::vector<std::string> warnings;
  if (const auto m = margins(scheme)) {
    const std::string sentence = objection(s, *m);
    if (sentence.empty()) return warnings;
    if (!force)
      user_error(
          "the coupling scheme {} would be unstable: {}. Use `scheme: linearised`, which is stable for any, "
          "or "
          "`force: true` to run all the same",
          name(scheme), sentence);
    warnings.push_back(fmt::format("the coupling scheme {} may be unstable: {}", name(scheme), sentence));
    return warnings;
  }
  const auto& x = s.exchange;
  if (x.filter_time > 0 && x.filter_time <= x.window && !force)
    user_error(
        "the filter time of the ports, {:.3g} ms, is not longer than the time between exchanges, {:.3g} ms, "
        "which is "
        "unstable; make it at least {:.3g} ms",
        1e3 * x.filter_time, 1e3 * x.window, 5e3 * (x.window + x.delay));
  if (auto sentence = filter_objection(x); !sentence.empty()) warnings.push_back(std::move(sentence));
  return warnings;
}

}  // namespace ostium::coupling
