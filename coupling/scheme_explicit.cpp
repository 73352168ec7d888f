#include "coupling/scheme_kinds.hpp"

namespace ostium::coupling {

namespace {

/// The pressure of the network stays until the next exchange.
class Held final : public Scheme {
  Laws laws(const network::Network& network, double, std::span<const double>) override {
    return held_pressures(network);
  }
};

/// The pressure goes on as it came from the last exchange to this one.
class Extrapolated final : public Scheme {
  Laws laws(const network::Network& network, double window, std::span<const double>) override {
    Laws next = held_pressures(network);
    for (size_t k = 0; k < next.size(); ++k) next[k].slope = (next[k].p_star - last_.pressure[k]) / window;
    return next;
  }
};

}  // namespace

std::unique_ptr<Scheme> make_held() { return std::make_unique<Held>(); }
std::unique_ptr<Scheme> make_extrapolated() { return std::make_unique<Extrapolated>(); }

}  // namespace ostium::coupling
