/// Clouds of shell particles for tests: strips, plates, discs, cylinders.
#pragma once
#include <cmath>
#include <random>

#include "sph3d/shell/step.hpp"

namespace ostium::sph3d {

template <int D>
void add(ShellCloud<D>& cloud, const Vec<D>& x, const Vec<D>& n, double area, double thickness,
         Support support = Support::free) {
  cloud.position.push_back(x);
  cloud.normal.push_back(n);
  cloud.area.push_back(area);
  cloud.thickness.push_back(thickness);
  cloud.support.push_back(support);
}

/// Particles in the middle of n cells along x from 0 to n dp, and `clamped` more beyond each end that is asked for.
inline ShellCloud<2> strip(int n, double dp, double thickness, int clamped_left, int clamped_right) {
  ShellCloud<2> cloud;
  for (int i = -clamped_left; i < n + clamped_right; ++i)
    add<2>(cloud, {(i + 0.5) * dp, 0.0}, {0.0, 1.0}, dp, thickness,
           i < 0 || i >= n ? Support::clamped : Support::free);
  return cloud;
}

/// A square lattice in the plane z = 0, cells (i + 1/2) dp, moved by up to jitter dp; support(i, j) by cell.
template <class F>
ShellCloud<3> plate(int nx, int ny, double dp, double thickness, F support, double jitter = 0.0) {
  ShellCloud<3> cloud;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-jitter * dp, jitter * dp);
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      const double x = (i + 0.5) * dp + shift(random), y = (j + 0.5) * dp + shift(random);
      add<3>(cloud, {x, y, 0.0}, {0.0, 0.0, 1.0}, dp * dp, thickness, support(i, j));
    }
  return cloud;
}

inline ShellCloud<3> free_plate(int nx, int ny, double dp, double thickness, double jitter = 0.0) {
  return plate(
      nx, ny, dp, thickness, [](int, int) { return Support::free; }, jitter);
}

/// A cylinder around z: rings of n particles, rows from z = 0 on, every other ring turned by half a spacing.
inline ShellCloud<3> cylinder(double radius, int n, int rows, double dz, double thickness) {
  ShellCloud<3> cloud;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < n; ++i) {
      const double phi = 2.0 * pi * i / n;
      const Vec3 normal(std::cos(phi), std::sin(phi), 0.0);
      add<3>(cloud, radius * normal + Vec3(0.0, 0.0, (j + 0.5) * dz), normal, 2.0 * pi * radius / n * dz,
             thickness);
    }
  cloud.axis.assign(cloud.count(), Vec3(0.0, 0.0, 1.0));
  return cloud;
}

/// A ring in the plane.
inline ShellCloud<2> ring(double radius, int n, double thickness) {
  ShellCloud<2> cloud;
  for (int i = 0; i < n; ++i) {
    const double phi = 2.0 * pi * i / n;
    const Vec2 normal(std::cos(phi), std::sin(phi));
    add<2>(cloud, radius * normal, normal, 2.0 * pi * radius / n, thickness);
  }
  return cloud;
}

/// Every particle moved to where x(X) says, its normal to n(X).
template <int D, class Place, class Normal>
void deform(const ShellModel<D>& model, ShellState<D>& state, Place place, Normal normal) {
  for (std::size_t a = 0; a < model.count(); ++a) {
    const Vec<D> X = model.cloud.position[a];
    state.displacement(a, place(X) - X);
    state.normal(a, normal(a).normalized());
  }
}

/// For equilibria: rotary scaling and little damping allow long steps.
inline ShellOptions static_options(double dp, double E, double nu) {
  return {.spacing = dp,
          .material = SaintVenantKirchhoff(elastic(E, nu)),
          .damping = 0.1,
          .rotary_scaling = true,
          .cfl = 0.9};
}

template <int D>
void set_force(std::vector<ShellLoad<D>>& load, std::size_t a, const Vec<D>& f) {
  for (int d = 0; d < D; ++d) load[a / 8].force[d][a % 8] = f[d];
}

}  // namespace ostium::sph3d
