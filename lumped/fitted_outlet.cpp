#include "lumped/fitted_outlet.hpp"

#include <cmath>

#include "core/log.hpp"

namespace ostium::lumped {

std::vector<Terminal> FittedOutlet::terminals() const {
  if (!from || from->empty()) user_error("has no `from`; name the node its flow comes from");
  return {{"from", *from, 0}};
}

/// Something must answer at once; a fit without resistance gets a millionth of what it has at rest.
void FittedOutlet::fit(const std::vector<ImpedanceSample>& samples) {
  Z = fit_impedance(samples, most_states);
  const double rest = Z(0).real();
  Z.D = std::max(Z.D, 1e-6 * std::max(rest, std::abs(samples.back().Z)));
  constexpr double noticeable = 0.05;
  if (Z.error > noticeable)
    log::warn("the impedance at \"{}\" is met to {:.2g} % only (root mean square)", from.value_or(""),
              100 * Z.error);
}

}  // namespace ostium::lumped
