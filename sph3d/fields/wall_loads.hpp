/// What the blood does to the wall, sampled after an advection step: pressure and wall shear stress at the wall points.
///
///   F_b   = sum_(i at b) m f_i (v_i - v_wall)           what friction has taken from the particles next to b
///   tau_a = (I - n n^T) sum_b w_ab F_b / A_a            w_ab smooths over the kernel and keeps the sum of the forces
///   p_a   = sum_i g_i p_i / sum_i g_i                   likewise smoothed; g = |grad S|, which fades with the distance
///
///   symbol    meaning                                                                         unit
///   tau       wall shear stress, the force of the fluid on the wall per present area          Pa
///   p         physical pressure                                                               Pa
///   f_i       friction rate of the particle (see step/prepare.hpp)                            1/s
///   w_ab      see point_weights.hpp; smoothing length h of the fluid                          -
///
/// The integral of tau over the wall is exactly the friction the fluid has felt, so its mean is right however rough a single
/// value is. On a rigid wall a particle belongs to the nearest point; on a shell its force is shared out as it is in the
/// exchange of momentum (WallMotion). Particles in the ducts do not count. Source: docs/theory/walls.md, "Wall shear stress".
/// Not checked: resolution of the boundary layer; a pulsatile flow needs at least five particles in it.
#pragma once
#include "sph3d/fields/nearest_wall_point.hpp"
#include "sph3d/fields/point_weights.hpp"
#include "sph3d/fields/wall_points.hpp"

namespace ostium::sph3d {

template <int D>
struct WallLoads {
  std::vector<Vec<D>> shear_stress;
  std::vector<double> pressure;
};

template <int D>
class WallSampler {
 public:
  explicit WallSampler(const Vessel<D>& vessel);

  /// Of the vessel as its last step has left it; the same for any number of threads.
  void sample(const Vessel<D>& vessel);

  const std::vector<WallPoint<D>>& at_rest() const { return rest_; }
  const std::vector<WallPoint<D>>& points() const { return now_; }
  const WallLoads<D>& loads() const { return loads_; }
  /// Sum of the forces that were received, N, before they were smoothed.
  Vec<D> force() const;

 private:
  struct Given {  // by a particle to a point
    std::int32_t point;
    float force[D], weight, psi;
  };
  struct Received {
    Vec<D> force = Vec<D>::Zero();
    double weight = 0, psi = 0;  // sums of g and of g psi
  };
  void to_nearest(const Vessel<D>& vessel);
  void by_motion(const Vessel<D>& vessel);
  void spread(const Vessel<D>& vessel);

  std::vector<WallPoint<D>> rest_, now_;
  NearestWallPoint<D> nearest_;
  PointWeights smoothing_;
  std::vector<std::vector<Given>> given_;  // of batches of clusters
  std::vector<Received> received_;
  std::vector<Vec<D>> shared_;
  WallLoads<D> loads_;
};

extern template class WallSampler<2>;
extern template class WallSampler<3>;

}  // namespace ostium::sph3d
