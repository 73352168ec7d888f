/// How well a freshly filled vessel is filled: density errors by distance to the wall and by branch.
///
///   error = (sum W V + filling by the wall) / sigma_0 - 1 - psi,   particles of the vessel without its ducts
///
///   sigma_0   number density the model was calibrated with
///   psi       density deviation the fluid starts with
#pragma once
#include <string>
#include <vector>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

/// Of one part of a vessel.
struct DensityErrors {
  std::string part = {};
  std::size_t count = 0;
  double squares = 0, sum = 0, largest = 0;

  void add(double error);
  double rms() const;
  double mean() const { return count ? sum / static_cast<double>(count) : 0; }
};

struct Filling {
  std::size_t particles = 0;
  double expected = 0;                    // volume of the vessel with its ducts over the particle volume
  std::size_t outside = 0;                // particles beyond the surface
  double outermost = 0;                   // largest signed distance over dp, negative inside
  DensityErrors all = {};                 // of the vessel without its ducts
  std::vector<DensityErrors> parts = {};  // layers from the wall, then branches, then depths behind a cap
  Vec3 worst = Vec3::Zero();              // where the largest error sits
  std::string worst_place = {};           // the same in words
};

Filling measure_filling(const Vessel<3>& vessel);

/// One line for the whole and one per part.
std::string table(const Filling& filling);

}  // namespace ostium::sph3d
