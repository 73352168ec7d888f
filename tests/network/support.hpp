/// Helpers of the tests of networks.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/vec.hpp"
#include "network/network.hpp"

namespace ostium::network {

inline Model model(const std::string& yaml) { return read_model(config::Node::parse(yaml, "case.yaml")); }

/// The sentence with which f() is refused.
template <class F>
std::string refusal(F&& f) {
  try {
    f();
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

inline std::string error_of(const std::string& yaml, const std::vector<Port>& ports = {}) {
  return refusal([&] { Network network(model(yaml), ports); });
}

/// Value of a series by its name.
inline double series(const Network& n, const std::string& name) {
  std::vector<double> values(n.series_names().size());
  n.series(values);
  for (size_t i = 0; i < values.size(); ++i)
    if (n.series_names()[i] == name) return values[i];
  ADD_FAILURE() << "no series " << name;
  return NAN;
}

/// To the time t without ports.
inline void run_to(Network& n, double t) {
  if (t > n.time()) n.advance(t - n.time(), {}, {});
}

inline NetworkOptions with(Method m) { return {.method = m}; }

}  // namespace ostium::network
