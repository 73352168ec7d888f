/// A wall of full thickness as the body behind the surface that the blood touches.
///
///   contact   x = X + u_a + H_a (X - X_a),  H = F - I,  a the particle of the innermost layer above X     m
///   normal    F_a^-T N, unit                                                                             -
///   area      J |F_a^-T A|                                                                               m^(D-1)
///
/// A force on a contact point does its work on that motion of it (solid_step.hpp), so that what the blood gives is what the wall
/// takes. The pressure of the tissue is left out of the stresses: pressures are differences to it. Source: docs/theory/walls.md,
/// "Walls that move"; docs/theory/solid.md.
#pragma once
#include "sph3d/geometry/sample.hpp"
#include "sph3d/solid/wall_cloud.hpp"
#include "sph3d/walls/deformable_wall_state.hpp"

namespace ostium::sph3d {

template <int D>
class SolidBody {
 public:
  using State = SolidState<D>;
  static constexpr auto state = &DeformableWallState<D>::solid;  ///< its part of the wall's state

  SolidBody(const WallCloud<D>& wall, const SolidOptions& options);

  std::size_t count() const { return wall_.contact.size(); }  ///< contact points
  double spacing() const { return model_.options.spacing; }
  const SolidModel<D>& model() const { return model_; }
  /// Layers, contact points and columns; the particles are those of the model.
  const WallCloud<D>& wall() const { return wall_; }

  const std::vector<Vec<D>>& reference() const { return wall_.contact; }
  const std::vector<Vec<D>>& reference_normals() const { return normal_; }
  State at_rest() const { return sph3d::at_rest(model_); }
  std::vector<Vec<D>> contacts(const State& solid) const;
  std::vector<Vec<D>> normals(const State& solid) const;
  /// Both, with present areas.
  std::vector<WallPoint<D>> points(const State& solid) const;
  /// By dt under forces on the contact points, N, and a pressure on the present surface, Pa.
  void step(State& solid, double dt, const std::vector<Vec<D>>& force, double pressure);

 private:
  WallCloud<D> wall_;
  std::vector<Vec<D>> normal_;  // of the contact points
  SolidModel<D> model_;
  SolidLoads<D> loads_;
  SolidWorkspace<D> work_;
};

extern template class SolidBody<2>;
extern template class SolidBody<3>;

}  // namespace ostium::sph3d
