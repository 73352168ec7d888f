/// An elastic body as particles with neighbours fixed in the reference configuration: what does not change while it moves.
///
///   M_a = sum_b (X_b - X_a) (x) grad W_ab V_b,    B_a = M_a^-1            (sums over the reference neighbours)
///   F_a = I + sum_b (u_b - u_a) (x) grad W_ab V_b B_a
///   Pi  = sum_a V_a [Psi(F_a) + alpha mu/2 sum_b s_ab |u_b - u_a - (F_a - I)(X_b - X_a)|^2],   s_ab = |W'|/r V_b
///
///   X           reference position                                               m
///   u           displacement                                                     m
///   volume      V, reference                                                     m^D
///   held        components of the motion that are not free, bit d for component d: clamped where the velocity is zero
///   stiffness   factor on the stress of the law, for walls that vary             -
///   fibres      directions in the reference configuration, for laws that have them
///   spacing     dp; smoothing length h = dp, support 2h; more for particles on irregular edges                     m
///   hourglass   alpha, what holds motions that F does not see                    -
///   damping     a, viscosity of the material over rho c h                        -
///
/// In 2D plane strain. Particles are best given in bisection order (neighbours/order.hpp). Source: docs/theory/solid.md.
/// Refused: density or spacing not positive, particles without enough neighbours, fibres missing. Not checked: that particles do
/// not overlap.
#pragma once
#include <cstdint>
#include <vector>

#include "sph3d/fluid/wendland.hpp"
#include "sph3d/structure/material.hpp"

namespace ostium::sph3d {

template <int D>
struct SolidCloud {
  std::vector<Vec<D>> position;
  std::vector<double> volume;
  std::vector<std::uint8_t> held = {};      ///< empty: all free
  std::vector<double> stiffness = {};       ///< empty: 1
  std::vector<Fibres<double>> fibres = {};  ///< needed by laws with fibres only

  std::size_t count() const { return position.size(); }
};

inline constexpr std::uint8_t hold_all = 7;

struct SolidOptions {
  Material material;
  double density, spacing;
  double hourglass = 1.0;
  double damping = 0.1;
};

template <int D>
struct SolidModel {
  static constexpr std::size_t lanes = 4;  ///< particles whose stress is computed side by side

  SolidCloud<D> cloud;
  SolidOptions options{.material = SaintVenantKirchhoff({1.0, 0.0}), .density = 1.0, .spacing = 1.0};
  Wendland<D> kernel;
  double viscosity = 0;  ///< a rho c h, Pa s

  std::vector<double> smoothing;        ///< h of each particle, a pair has the wider one, m
  std::vector<std::int64_t> row;        ///< first pair of each particle, and the end
  std::vector<std::int32_t> neighbour;  ///< of each pair
  /// Per pair grad W_ab V_b, then the spring alpha mu (stiffness_a + stiffness_b) s_ab, Pa/m2: D + 1 numbers.
  std::vector<double> weight;
  /// Per group of four particles, four numbers each: the components of B; the stiffness; two fibres.
  std::vector<double> correction, factor, fibre;

  std::size_t count() const { return cloud.count(); }
  std::size_t pairs() const { return neighbour.size(); }
  std::size_t groups() const { return (count() + lanes - 1) / lanes; }
  Mat<D> correction_of(std::size_t a) const;
  double mass(std::size_t a) const { return options.density * cloud.volume[a]; }
  Fibres<double> fibres_of(std::size_t a) const {
    return cloud.fibres.empty() ? Fibres<double>{} : cloud.fibres[a];
  }
  double stiffness_of(std::size_t a) const { return cloud.stiffness.empty() ? 1.0 : cloud.stiffness[a]; }
};

/// grad W_ab V_b of a pair, 1/m.
template <int D>
Eigen::Map<const Vec<D>> pair_gradient(const SolidModel<D>& model, std::int64_t pair) {
  return Eigen::Map<const Vec<D>>(&model.weight[(D + 1) * pair]);
}

template <int D>
SolidModel<D> make_solid(SolidCloud<D> cloud, const SolidOptions& options);

}  // namespace ostium::sph3d
