#include "sph3d/structure/holzapfel.hpp"

#include "core/error.hpp"

namespace ostium::sph3d {

Holzapfel holzapfel(const Moduli& rubber, const FibreParameters& f, const char* what) {
  if (!(f.k1 > 0.0)) user_error("The fibre stiffness k1 of {} must be positive; found {:g} Pa.", what, f.k1);
  if (!(f.k2 > 0.0))
    user_error("The stiffening k2 of the fibres of {} must be positive; found {:g}.", what, f.k2);
  if (!(f.kappa >= 0.0 && f.kappa <= 1.0 / 3.0))
    user_error(
        "The dispersion kappa of the fibres of {} must lie between 0 (all in one direction) and 1/3 (in all "
        "directions alike); found {:g}.",
        what, f.kappa);
  return {NeoHookean(rubber), f.k1, f.k2, f.kappa};
}

double Holzapfel::plate_modulus(double stretch) const {
  const double along = 1.0 - 2.0 * kappa;  // H_aa
  const double e = std::max(stretch * stretch - 1.0, 0.0);
  const double fibre = 4.0 * k1 * along * along * (1.0 + 2.0 * k2 * e * e) * std::exp(k2 * e * e);
  return rubber.plate_modulus(stretch) + 2.0 * fibre * stretch * stretch;
}

}  // namespace ostium::sph3d
