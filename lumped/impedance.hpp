/// Outlet with a measured or computed impedance, given by its values at some frequencies.
///
///   from o---[ Z ]---o Pd
///
///   p_from - Pd = Z q,   Z(f_n) = modulus_n e^(i phase_n)
///
/// Met by a passive rational impedance with at most 12 states (lumped/impedance_fit; lumped/fitted_outlet has the
/// equations and the series), Z(0) exactly if given. An error above 5 % is told: a table that is not that of something
/// passive cannot be met.
///
///   q            m3/s      flow entering at `from`
///   frequency    Hz        increasing, >= 0
///   modulus      Pa.s/m3   > 0
///   phase        rad       negative where the pressure lags
///
/// Example:
///   leg: {type: impedance, from: femoral, frequency: 0 1 2 3 4 Hz, modulus: 1.2e9 2.6e8 1.5e8 1.2e8 1.1e8 Pa.s/m3,
///       phase: 0 -60 -50 -35 -25 deg}
///
/// Source: Gustavsen & Semlyen, IEEE Trans. Power Deliv. 14 (1999) 1052, on rational fits; here passive by construction.
/// Not checked: that the table resolves the signal.
#pragma once
#include "lumped/fitted_outlet.hpp"

namespace ostium::lumped {

struct Impedance : FittedOutlet {
  std::vector<double> frequency, modulus, phase;

  static constexpr const char* type = "impedance";

  template <class T>
  void equations(const In<Impedance, T>& x, Out<Impedance, T>& f) const {
    outlet(x, f);
  }
  void prepare();
};

void declare(config::Fields<Impedance>& f);

}  // namespace ostium::lumped
