/// The probes of a case, found in its vessel.
///
/// A probe in the blood lies inside the vessel, one on the wall at most two spacings from it. Throws UserError
/// with the position in the case file, the distance and the nearest point of the wall.
#pragma once
#include <string>
#include <vector>

#include "app/case.hpp"
#include "sph3d/geometry/lumen.hpp"

namespace ostium::app {

template <int D>
struct Probe {
  std::string name;
  bool on_wall = false;
  Vec<D> at =
      Vec<D>::Zero();  // m; of the wall the point nearest to what the case says, as the wall is at first
  Vec<D> normal = Vec<D>::Zero();  // of the wall there
};

template <int D>
std::vector<Probe<D>> probes_of(const Case& study, const sph3d::Lumen<D>& lumen);

/// "in the blood at [0.1 m, 0.05 m]"
template <int D>
std::string place_of(const Probe<D>& probe);

}  // namespace ostium::app
