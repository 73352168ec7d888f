/// Whether the boundary layer is resolved: the wall shear stress of the forces against that of the velocity gradient.
///
///   |tau_F| = (1/n) sum |tau_F(t_k)|,  |tau_g| likewise       mean magnitudes over the instants t_k of a cycle
///   d = | |tau_F| - |tau_g| | / max(|tau_F|, |tau_g|, mean of |tau_F| over the wall / 4)
///
///   symbol   meaning                                                                              unit
///   tau_F    stress of the forces (wall_loads.hpp), filtered as in wall_cycle.hpp                 Pa
///   tau_g    stress of the gradient (wall_gradient.hpp)                                           Pa
///   d        by how much both differ at a wall point; where the stress is small beside the mean, relative to that        -
///
/// Both measures come to the same where the flow beside the wall is resolved. Plain data, so that a checkpoint holds it.
/// Source: docs/theory/walls.md, "Wall shear stress". Not checked: that the instants are dense enough; thirty in a cycle are.
#pragma once
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/vec.hpp"
#include "sph3d/fields/wall_points.hpp"

namespace ostium::sph3d {

struct StressSums {
  std::int64_t count = 0;                ///< of instants
  std::vector<double> forces, gradient;  ///< sums of magnitudes, Pa
};

struct StressAgreement {
  std::int64_t cycle = 0;     ///< that is running, from 0
  double time = -1;           ///< of the last instant, s
  StressSums running, whole;  ///< of this cycle so far, of the last one that has ended
};

void archive(Archive& a, StressAgreement& agreement);

/// Takes both stresses at an instant of this cycle.
template <int D>
void take(StressAgreement& agreement, std::int64_t cycle, double time, const std::vector<Vec<D>>& forces,
          const std::vector<Vec<D>>& gradient);

struct Disagreement {
  double share = 0;                 ///< of the wall's area where d > 0.1
  double median = 0;                ///< of d, by area
  std::size_t worst = 0;            ///< wall point with the largest d
  double forces = 0, gradient = 0;  ///< there, Pa
};

/// Over points at rest; all zero where nothing was taken.
template <int D>
Disagreement disagreement(const StressSums& sums, const std::vector<WallPoint<D>>& wall);

}  // namespace ostium::sph3d
