/// Visiting the particles next to the wall. Internal to fields/.
#pragma once
#include <algorithm>
#include <cmath>

#include "sph3d/step/lane_access.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

/// f(place, cluster, |grad S|) for the particles outside the ducts that feel the wall, of the clusters [begin, end).
template <int D, class F>
void for_near_wall(const Vessel<D>& vessel, std::size_t begin, std::size_t end, F&& f) {
  const auto& fluid = vessel.state().fluid;
  const auto& duct_of = vessel.workspace().duct_of;
  // places that have come since the step began have felt nothing yet
  end = std::min({end, fluid.clusters.size(), duct_of.size() / 8});
  for (std::size_t c = begin; c < end; ++c) {
    const Cluster<D>& own = fluid.clusters[c];
    float flux2[8] = {};
    for (int d = 0; d < D; ++d)
      for (int lane = 0; lane < 8; ++lane) flux2[lane] += own.wall[d][lane] * own.wall[d][lane];
    if (*std::max_element(flux2, flux2 + 8) <= 0.0f) continue;
    for (std::size_t i = 8 * c; i < 8 * c + 8; ++i)
      if (flux2[i % 8] > 0.0f && fluid.filled[i] && duct_of[i] < 0) f(i, own, std::sqrt(flux2[i % 8]));
  }
}

}  // namespace ostium::sph3d
