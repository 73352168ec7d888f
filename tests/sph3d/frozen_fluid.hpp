/// A fluid that does not move, with lengths in particle spacings: what is summed near a wall, and the steady flow that
/// the discrete viscosity has among particles held where they are.
///
///   neighbours   sums of the particles alone:  sum W V,  sum grad W V,  -sum r (x) grad W V
///   steady flow  sum_j 2 g_ij (u_i - u_j)/r W' V - (F_i : B_i) u_i + 1 = 0,   g_ij = e.(B_i + B_j)e / 2
///
///   wall     what a particle sees of the wall (bench/layers.hpp)
///   period   of the cloud in each direction; 0: not periodic
#pragma once
#include <functional>

#include "bench/layers.hpp"

namespace ostium::sph3d {

template <int D>
using Wall = std::function<bench::WallSums<D>(const Vec<D>&)>;

template <int D>
struct FrozenFluid {
  std::vector<Vec<D>> points;
  Vec<D> period = Vec<D>::Zero();
  Wendland<D> kernel{1.3};

  /// Towards uniform number density, by the rule a vessel is filled with (particles/relax.hpp).
  void relax(const Wall<D>& wall, int iterations);

  std::vector<bench::WallSums<D>> sums() const;  // friction apart
  /// Velocity at a unit of force per mass and of viscosity.
  std::vector<double> steady_flow(const Wall<D>& wall) const;
  /// Rate F : B at which the wall slows each particle, 1/dp^2.
  std::vector<double> friction(const Wall<D>& wall) const;

 private:
  struct Pair {
    int j;
    Vec<D> r;
  };
  std::vector<std::vector<Pair>> pairs(double reach) const;
  std::vector<Mat<D>> corrections(const Wall<D>& wall) const;
};

extern template struct FrozenFluid<2>;
extern template struct FrozenFluid<3>;

}  // namespace ostium::sph3d
