/// Walls as virtual layers behind shell particles, what the filling field is measured against; no part of the program.
///
///   x_a^k = x_a + k d n_a,  k = 0, 1, 2, ...     V_a^k = A_a d chi^k,   chi^k = prod_c (1 + k d kappa_c)
///
///   sum_a sum_k of  W V  (filling),  grad W V  (gradient),  -r (x) grad W V  (moment),
///                   2 lambda |W'| / r e (x) e V  (friction: the wall slows a particle at the rate nu F : B)
///
///   symbol   meaning                                                                  unit
///   x_a      shell particle, half a shell spacing behind the surface of the wall      m
///   n_a      normal, out of the fluid                                                 -
///   d        spacing of the shell and of its layers                                   m
///   A_a      area (2D: length)                                                        m^(D-1)
///   kappa    curvatures of the surface, positive where the layers fan out             1/m
///   s        distance of the fluid particle to the surface                            m
///
/// A shell particle belongs to the neighbours where its layer 0 does; its layers end where one of the factors of chi is not
/// positive. lambda: see LayerFriction. Source: the shell walls of
/// Zhao, Wu, Kong, Haidn & Hu, Toward Efficient FSI Modeling in Patient-Specific Arteries (SPH, thin deformable vessels);
/// docs/theory/walls.md, section "Measured against virtual layers".
#pragma once
#include "bench/cells.hpp"
#include "sph3d/walls/half_space.hpp"
#include "sph3d/walls/wall_field.hpp"

namespace ostium::bench {

using sph3d::Wendland;

/// What a fluid particle sees of a wall.
template <int D>
struct WallSums {
  double filling = 0;                // -
  Vec<D> gradient = Vec<D>::Zero();  // 1/m
  Mat<D> moment = Mat<D>::Zero();    // -
  Mat<D> friction = Mat<D>::Zero();  // 1/m2
};

/// lambda = 2 mirrors the velocity at the surface; otherwise it goes on linearly through it,
/// lambda = 1 + min(depth / max(s, dp/4), most).
struct LayerFriction {
  bool own_distance = true;  // r of each layer; otherwise that of layer 0 for all of them
  bool mirror = false;
  double most = 2;
};

template <int D>
struct Shell {
  Vec<D> x, n;
  double area;
  std::array<double, D - 1> curvature{};
};

template <int D>
class Layers {
 public:
  Layers(std::vector<Shell<D>> shells, double spacing, const Wendland<D>& kernel, double dp,
         LayerFriction friction = {})
      : shells_(std::move(shells)),
        spacing_(spacing),
        dp_(dp),
        kernel_(kernel),
        friction_(friction),
        places_(places(shells_)),
        cells_(places_, kernel.reach()) {}
  Layers(const Layers&) = delete;

  const std::vector<Shell<D>>& shells() const { return shells_; }
  double spacing() const { return spacing_; }

  WallSums<D> operator()(const Vec<D>& x, double s) const {
    WallSums<D> sums;
    cells_.near(x, [&](int a, const Vec<D>& r0) { add(shells_[a], r0, s, sums); });
    return sums;
  }

 private:
  static std::vector<Vec<D>> places(const std::vector<Shell<D>>& shells) {
    std::vector<Vec<D>> x;
    for (const auto& shell : shells) x.push_back(shell.x);
    return x;
  }

  double lambda(int k, double s) const {
    const double ratio = (k + 0.5) * spacing_ / std::max(s, 0.25 * dp_);
    return friction_.mirror ? 2.0 : 1.0 + std::min(ratio, friction_.most);
  }

  void add(const Shell<D>& a, const Vec<D>& r0, double s, WallSums<D>& sums) const {
    const double first = r0.norm();
    for (int k = 0;; ++k) {
      const Vec<D> r_k = r0 - k * spacing_ * a.n;
      const double r = r_k.norm();
      if (r >= kernel_.reach()) return;
      double volume = a.area * spacing_;
      for (const double kappa : a.curvature) {
        const double chi = 1.0 + k * spacing_ * kappa;
        if (chi <= 0.0) return;
        volume *= chi;
      }
      const Vec<D> e = r_k / r;
      const double slope = kernel_.slope(r) * volume;
      sums.filling += kernel_.value(r) * volume;
      sums.gradient += slope * e;
      sums.moment -= r * slope * e * e.transpose();
      sums.friction -= 2.0 * lambda(k, s) * slope / (friction_.own_distance ? r : first) * e * e.transpose();
    }
  }

  std::vector<Shell<D>> shells_;
  double spacing_, dp_;
  Wendland<D> kernel_;
  LayerFriction friction_;
  std::vector<Vec<D>> places_;
  Cells<D> cells_;
};

/// The same of the program's own wall, as the half-space at distance s.
template <int D>
WallSums<D> sums_of(const sph3d::WallSample<D>& wall, double s, const sph3d::HalfSpace<D>& space) {
  if (!(wall.filling > 0.0)) return {};
  const Vec<D> n = wall.flux.normalized();
  const Mat<D> along = n * n.transpose(), across = Mat<D>::Identity() - along;
  return {wall.filling, wall.flux, space.moment_n(s) * along + space.moment_t(s) * across,
          space.friction_n(s) * along + space.friction_t(s) * across};
}

/// Shells of a plane x_D = at with the normal along x_D times `side`, on a lattice over [lower, upper] in the other
/// directions that has a point at 0.
template <int D>
std::vector<Shell<D>> plane_shells(double at, int side, double lower, double upper, double spacing) {
  std::vector<Shell<D>> shells;
  const int first = static_cast<int>(std::ceil(lower / spacing)), last = static_cast<int>(upper / spacing);
  for (int j = D == 3 ? first : 0; j <= (D == 3 ? last : 0); ++j)
    for (int i = first; i <= last; ++i) {
      Shell<D> a{.x = Vec<D>::Zero(), .n = side * Vec<D>::Unit(D - 1), .area = std::pow(spacing, D - 1)};
      a.x[0] = i * spacing;
      if constexpr (D == 3) a.x[1] = j * spacing;
      a.x[D - 1] = at + 0.5 * side * spacing;
      shells.push_back(a);
    }
  return shells;
}

/// Shells around the axis x_3 (2D: around the origin) of a wall of radius R, in so many rings from x_3 = lower to upper,
/// with the exact curvature.
template <int D>
std::vector<Shell<D>> tube_shells(double R, double spacing, double lower, double upper, int rings) {
  std::vector<Shell<D>> shells;
  const double radius = R + 0.5 * spacing;
  const int around = static_cast<int>(std::ceil(2 * pi * radius / spacing));
  const double step = D == 3 ? (upper - lower) / rings : 1.0;
  for (int k = 0; k < (D == 3 ? rings : 1); ++k)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around;
      Shell<D> a{.x = Vec<D>::Zero(), .n = Vec<D>::Zero(), .area = 2 * pi * radius / around * step};
      a.n[0] = std::cos(angle), a.n[1] = std::sin(angle);
      a.x = radius * a.n;
      if constexpr (D == 3) a.x[2] = lower + (k + 0.5) * step;
      a.curvature[0] = 1.0 / radius;
      shells.push_back(a);
    }
  return shells;
}

}  // namespace ostium::bench
