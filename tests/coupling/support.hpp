/// Helpers of the tests of coupling schemes: networks of single Windkessels and their closed forms.
#pragma once
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>

#include "core/error.hpp"
#include "core/vec.hpp"
#include "coupling/scheme.hpp"

namespace ostium::coupling {

struct Rcr {
  double Rp, C, Rd;
  std::complex<double> impedance(double omega) const {
    return Rp + Rd / std::complex<double>(1, omega * Rd * C);
  }
  /// Beside each other at `at` openings named A, B, ..
  std::string yaml(char opening = 'A') const {
    return fmt::format(
        "{0}_out: {{type: windkessel, from: {0}, Rp: {1} Pa.s/m3, C: {2} m3/Pa, Rd: {3} Pa.s/m3, "
        "initial_pressure: {4} Pa}}\n",
        opening, Rp, C, Rd, start);
  }
  double start = 0;  // Pa on C
};

inline network::Network network_of(const std::string& yaml, const std::vector<network::Port>& ports) {
  return network::Network(network::read_model(config::Node::parse(yaml, "case.yaml")), ports);
}

/// The inflow mean (1 - cos 2 pi t / period) and the pressure it makes in a Windkessel.
struct OneMinusCosine {
  double mean, period = 1.0;
  double omega() const { return 2 * pi / period; }
  double flow(double t) const { return mean * (1 - std::cos(omega() * t)); }
  double periodic_pressure(const Rcr& w, double t) const {
    return mean *
           ((w.Rp + w.Rd) - (w.impedance(omega()) * std::exp(std::complex<double>(0, omega() * t))).real());
  }
  /// On the compliance at t = 0 when periodic.
  double periodic_start(const Rcr& w) const { return periodic_pressure(w, 0); }
  /// From Pc(0) = w.start.
  double pressure(const Rcr& w, double t) const {
    return periodic_pressure(w, t) + (w.start - periodic_start(w)) * std::exp(-t / (w.Rd * w.C));
  }
};

}  // namespace ostium::coupling
