#include "coupling/scheme_kinds.hpp"

namespace ostium::coupling {

namespace {

/// The port follows the flow at once, the network corrects at every exchange.
class Linearised final : public Scheme {
  Laws first(const network::Network& network, double window) override {
    return linearised(network, window, network.save().port_flow);
  }

  Laws laws(const network::Network& network, double window, std::span<const double> mean_flow) override {
    return linearised(network, window, mean_flow);
  }

  static Laws linearised(const network::Network& network, double window, std::span<const double> flow) {
    const Eigen::VectorXd R = network.port_resistance(window).cwiseAbs().rowwise().sum();
    Laws next(network.port_count());
    for (int k = 0; k < network.port_count(); ++k)
      next[k] = {network.pressure(k), network.pressure_slope(k), R[k], flow[k]};
    return next;
  }
};

}  // namespace

std::unique_ptr<Scheme> make_linearised() { return std::make_unique<Linearised>(); }

}  // namespace ostium::coupling
