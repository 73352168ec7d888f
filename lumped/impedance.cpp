#include "lumped/impedance.hpp"

#include <numbers>

namespace ostium::lumped {

void Impedance::prepare() {
  std::vector<ImpedanceSample> samples;
  for (std::size_t n = 0; n < frequency.size(); ++n)
    samples.push_back({2 * std::numbers::pi * frequency[n], std::polar(modulus[n], phase[n])});
  fit(samples);
}

namespace {

std::string check_table(const Impedance& z) {
  const std::size_t n = z.frequency.size();
  if (n < 2 || z.modulus.size() != n || z.phase.size() != n)
    return fmt::format(
        "\"frequency\" has {} values, \"modulus\" {} and \"phase\" {}; they belong together one by one, "
        "and two frequencies are the least",
        n, z.modulus.size(), z.phase.size());
  for (std::size_t k = 0; k < n; ++k) {
    if (z.frequency[k] < 0 || (k > 0 && z.frequency[k] <= z.frequency[k - 1]))
      return fmt::format("the {}. \"frequency\" is {:g} Hz; frequencies must be >= 0 and increase", k + 1,
                         z.frequency[k]);
    if (!(z.modulus[k] > 0))
      return fmt::format("the {}. \"modulus\" is {:g} Pa.s/m3, it must be > 0", k + 1, z.modulus[k]);
    if (std::abs(z.phase[k]) > std::numbers::pi / 2 * (1 + 1e-9) || (z.frequency[k] == 0 && z.phase[k] != 0))
      return fmt::format(
          "the {}. \"phase\" is {:g} rad; an outlet takes energy up at every frequency, so that phases "
          "lie between -pi/2 and pi/2, and at 0 Hz it is 0",
          k + 1, z.phase[k]);
  }
  return {};
}

}  // namespace

void declare(config::Fields<Impedance>& f) {
  declare_outlet(f);
  f.list("frequency", &Impedance::frequency, "Hz", "frequencies of the table, increasing");
  f.list("modulus", &Impedance::modulus, "Pa.s/m3", "modulus of the impedance at each");
  f.list("phase", &Impedance::phase, "rad", "phase of the impedance at each");
  f.check(check_table);
}

}  // namespace ostium::lumped
