/// The blood at any place in the vessel: velocity and pressure between the particles.
///
///   f(x) = sum_i w_i f_i,   w_i ~ W(x - x_i) (1 - a . (x_i - x)),   sum w_i = 1,   sum w_i (x_i - x) = 0
///
///   symbol     meaning                                                           unit
///   velocity   of the blood                                                      m/s
///   pressure   physical: the datum of the fluid solver added back                Pa
///   W          kernel of the fluid
///   a          that makes linear fields exact, beside a wall as well             1/m
///
/// The error is of second order in h. Where the particles lie so much to one side that the linear part would
/// be guessed, the weights are those of the kernel alone, of first order. Particles in the ducts count.
/// Source: Bonet & Lok 1999; docs/theory/walls.md, "Probes". Not checked: whether all particles within the
/// reach are on the same side of a thin wall.
#pragma once
#include <optional>

#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

template <int D>
struct BloodSample {
  Vec<D> velocity = Vec<D>::Zero();
  double pressure = 0;
};

/// Nothing where particles fill less than a tenth of the kernel: where the wall has come. Looks at every
/// particle.
template <int D>
std::optional<BloodSample<D>> blood_at(const Vessel<D>& vessel, const Vec<D>& x);

}  // namespace ostium::sph3d
