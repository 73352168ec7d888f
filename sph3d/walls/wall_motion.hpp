/// A wall that moves: where its points stand now, and what the particles near it feel of that.
///
///   X(x) = sum_a w_a [X_a + R_a^T (x - x_a)]         the place in the wall's reference that x corresponds to
///   S(x) = S_0(X),    grad S(x) = R grad S_0(X)      filling, from the field of the wall as it was at first
///   v(x) = sum_a w_a v_a,    F_a = sum_i w_ia F_i    velocity that is felt, force that is received
///
///   symbol   meaning                                                                         unit
///   X_a x_a  wall point on the surface that the blood touches, in the reference and now      m
///   R_a      smallest rotation that turns its normal from the reference to now               -
///   w_a      weights about the foot of x on the wall: sum 1, and sum w_a x_a is the foot     -
///
/// With the wall at rest in its reference X = x: rigid walls are the same, with the motion left out. The same weights carry
/// velocity one way and force the other, so that the power the fluid loses is what the wall receives. Where no wall point
/// is near, the wall is that of the reference. Source: docs/theory/walls.md, "Walls that move". Not checked: that the wall has
/// not turned by half a turn, nor folded.
#pragma once
#include <vector>

#include "core/vec.hpp"
#include "sph3d/fluid/fluid_state.hpp"
#include "sph3d/walls/wall_field.hpp"

namespace ostium::sph3d {

template <int D>
class WallMotion {
 public:
  /// `normal` out of the blood; spacing of the wall points, and the reach of the fluid's kernel, m.
  WallMotion(std::vector<Vec<D>> reference, std::vector<Vec<D>> normal, double spacing, double reach);

  /// Lists, for every particle of the fluid that is near the wall, the wall points about its foot.
  void attach(const FluidState<D>& fluid, const std::vector<Vec<D>>& now, const std::vector<Vec<D>>& normal);

  /// What the particle in place i feels at x, a place at the time it was attached.
  WallSample<D> sample(const WallField<D>& field, std::size_t i, const Vec<D>& x) const;

  /// From now on the wall points move like this.
  void set_velocities(const std::vector<Vec<D>>& velocity);
  /// Adds to what wall and particles have moved since they were attached.
  void drift(double dt);

  /// How many there were when they were attached; none before the first time.
  std::size_t places() const { return lists_.size(); }
  bool attached(std::size_t i) const { return lists_[i].count > 0; }
  /// Of the wall as each place feels it, cluster by cluster.
  const WallVelocity<D>* velocity() const { return velocity_.data(); }
  Vec<D> moved(std::size_t i) const;

  /// F_a, from force(i) of every attached place; the same for any number of threads.
  template <class Force>
  void gather(std::vector<Vec<D>>& sum, Force&& force) const {
#pragma omp parallel for schedule(static)
    for (std::size_t a = 0; a < sum.size(); ++a) {
      sum[a].setZero();
      for (std::int64_t n = of_point_begin_[a]; n < of_point_begin_[a + 1]; ++n)
        sum[a] += double(of_point_[n].weight) * force(std::size_t(of_point_[n].index));
    }
  }

 private:
  struct Entry {
    std::int32_t index;
    float weight;
  };
  struct List {
    std::int32_t thread = 0, count = 0;
    std::int64_t begin = 0;
  };
  struct Pose {  // of a wall point, when attached
    Vec<D> position, normal;
    Mat<D> turn;
  };
  const Entry* entries(std::size_t i) const { return storage_[lists_[i].thread].data() + lists_[i].begin; }
  struct Near {  // of the wall points beside a cluster, side by side in memory
    Vec<D> position, normal;
    std::int32_t index;
  };
  int find_weights(const Vec<D>& x, const std::vector<Near>& near, std::vector<Entry>& out) const;
  void transpose();

  std::vector<Vec<D>> reference_, reference_normal_;
  double spacing_, reach_;
  double felt_ = 0;  // reach and the largest displacement, so that who has lost the wall knows
  std::vector<Pose> pose_;
  std::vector<List> lists_;  // of each place
  std::vector<std::vector<Entry>> storage_;
  std::vector<std::int64_t> of_point_begin_;
  std::vector<Entry> of_point_;  // places and weights of each wall point
  std::vector<WallVelocity<D>> velocity_, moved_;
};

extern template class WallMotion<2>;
extern template class WallMotion<3>;

}  // namespace ostium::sph3d
