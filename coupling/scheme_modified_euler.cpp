#include "core/error.hpp"
#include "coupling/scheme_kinds.hpp"
#include "lumped/windkessel.hpp"

namespace ostium::coupling {

namespace {

using lumped::Windkessel;

const Windkessel* grounded_windkessel(const lumped::Block* block) {
  const auto* found = dynamic_cast<const lumped::BlockOf<Windkessel>*>(block);
  return found && found->terminals()[Windkessel::To].grounded() ? &found->fields() : nullptr;
}

/// Heun's method on the differentiated Windkessel, with the same counted flow in both stages, as published.
class ModifiedEuler final : public Scheme {
 public:
  explicit ModifiedEuler(const network::Network& network) {
    for (int k = 0; k < network.port_count(); ++k) {
      windkessels_.push_back({});
      if (network.kind(k) == network::PortKind::flow) continue;
      const auto block = network.only_block(k);
      const Windkessel* w = grounded_windkessel(block.get());
      if (!w)
        user_error(
            "{}: the scheme modified_euler knows only openings with a single windkessel that ends at its "
            "distal "
            "pressure, and \"{}\" is another one; use `scheme: linearised`",
            network.where(), network.port(k).opening);
      windkessels_.back() = *w;
    }
  }

 private:
  Laws laws(const network::Network& network, double window, std::span<const double> mean_flow) override {
    Laws next(network.port_count());
    for (int k = 0; k < network.port_count(); ++k)
      if (network.kind(k) == network::PortKind::pressure) next[k].p_star = advanced(k, window, mean_flow[k]);
    return next;
  }

  double advanced(int k, double tau, double Q) const {
    const auto& w = windkessels_[k];
    const double Pd = w.Pd.value_or(0), P = last_.pressure[k] - Pd, dQ = (Q - last_.flow[k]) / tau;
    const auto rate = [&](double p) { return (-p + (w.Rp + w.Rd) * Q) / (w.C * w.Rd) + w.Rp * dQ; };
    const double k1 = rate(P), k2 = rate(P + tau * k1);
    return Pd + P + 0.5 * tau * (k1 + k2);
  }

  std::vector<Windkessel> windkessels_;  // one per port, unused for flow ports
};

}  // namespace

std::unique_ptr<Scheme> make_modified_euler(const network::Network& network) {
  return std::make_unique<ModifiedEuler>(network);
}

}  // namespace ostium::coupling
