#include "coupling/scheme.hpp"

#include "coupling/scheme_kinds.hpp"

namespace ostium::coupling {

const char* name(SchemeKind kind) {
  switch (kind) {
    case SchemeKind::held:
      return "held";
    case SchemeKind::extrapolated:
      return "extrapolated";
    case SchemeKind::linearised:
      return "linearised";
    case SchemeKind::modified_euler:
      return "modified_euler";
  }
  return "";
}

Laws held_pressures(const network::Network& network) {
  Laws laws(network.port_count());
  for (int k = 0; k < network.port_count(); ++k) laws[k].p_star = network.pressure(k);
  return laws;
}

Laws Scheme::first(const network::Network& network, double) { return held_pressures(network); }

Laws Scheme::start(const network::Network& network, double window) {
  Laws laws = first(network, window);
  last_ = {{}, network.save().port_flow};
  for (const auto& law : laws) last_.pressure.push_back(law.p_star);
  return laws;
}

Laws Scheme::exchange(network::Network& network, double window, std::span<const double> mean_flow) {
  // Held over the window: the network receives exactly the counted volume, whatever the windows' lengths.
  network.advance(window, mean_flow, mean_flow);
  Laws next = laws(network, window, mean_flow);
  for (size_t k = 0; k < next.size(); ++k) last_.pressure[k] = next[k].p_star;
  last_.flow.assign(mean_flow.begin(), mean_flow.end());
  return next;
}

std::unique_ptr<Scheme> make_scheme(SchemeKind kind, const network::Network& network) {
  switch (kind) {
    case SchemeKind::held:
      return make_held();
    case SchemeKind::extrapolated:
      return make_extrapolated();
    case SchemeKind::linearised:
      return make_linearised();
    case SchemeKind::modified_euler:
      return make_modified_euler(network);
  }
  return nullptr;
}

}  // namespace ostium::coupling
