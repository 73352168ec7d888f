/// Helpers of the tests of blocks.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/config.hpp"
#include "lumped/registry.hpp"

namespace ostium::lumped {

inline std::shared_ptr<const Block> block(const std::string& yaml) {
  return read_block(config::Node::parse("b: " + yaml, "case.yaml").at("b"));
}

/// What the block answers: [own equations, flows into its ports] for x = [p, y, dy].
inline std::vector<double> answer(const Block& b, const std::vector<double>& x, double t = 0) {
  EXPECT_EQ(static_cast<int>(x.size()), b.input_count());
  std::vector<double> f(b.equation_count());
  b.residual(t, x.data(), f.data());
  return f;
}

/// The dual-number Jacobian against central differences with steps of each input's own size.
inline void expect_exact_jacobian(const Block& b, std::vector<double> x, double t = 0.1) {
  const int n = b.input_count(), m = b.equation_count();
  std::vector<double> J(n * m), up(m), down(m);
  b.jacobian(t, x.data(), J.data());
  for (int j = 0; j < n; ++j) {
    const double h = 1e-4 * std::max(std::abs(x[j]), 1e-6), kept = x[j];
    x[j] = kept + h;
    b.residual(t, x.data(), up.data());
    x[j] = kept - h;
    b.residual(t, x.data(), down.data());
    x[j] = kept;
    for (int i = 0; i < m; ++i) {
      const double difference = (up[i] - down[i]) / (2 * h);
      EXPECT_NEAR(J[i * n + j], difference, 1e-5 * std::abs(difference) + 1e-15)
          << "equation " << i << ", input " << j;
    }
  }
}

inline std::string error_of(const std::string& yaml) {
  try {
    block(yaml);
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace ostium::lumped
