/// A shell as the body behind the surface that the blood touches.
///
///   contact   r - d n, with the shell's pseudo-normal n and the depth d of its mid-surface        m
///   area      A |(x_1 - d n_1) x (x_2 - d n_2)|, from the tangents of mid-surface and pseudo-normal    m^(D-1)
///
/// A force on a contact point acts on the particle behind it, without the moment about the mid-surface. Source:
/// docs/theory/walls.md, "Walls that move". Not checked: that the shell has not folded.
#pragma once
#include "sph3d/geometry/sample.hpp"
#include "sph3d/shell/stable_step.hpp"
#include "sph3d/shell/step.hpp"
#include "sph3d/walls/deformable_wall_state.hpp"

namespace ostium::sph3d {

template <int D>
class ShellBody {
 public:
  using State = ShellState<D>;
  static constexpr auto state = &DeformableWallState<D>::shell;  ///< its part of the wall's state

  /// `contact` of every particle of the shell, in the reference.
  ShellBody(ShellModel<D> model, std::vector<Vec<D>> contact);

  std::size_t count() const { return model_.count(); }  ///< contact points
  double spacing() const { return model_.options.spacing; }
  const ShellModel<D>& model() const { return model_; }

  const std::vector<Vec<D>>& reference() const { return contact_; }
  const std::vector<Vec<D>>& reference_normals() const { return model_.cloud.normal; }
  State at_rest() const { return rest(model_); }
  std::vector<Vec<D>> contacts(const State& shell) const;
  std::vector<Vec<D>> normals(const State& shell) const;
  /// Both, with present areas.
  std::vector<WallPoint<D>> points(const State& shell) const;
  /// By dt under forces on the contact points, N, and a pressure on the present surface, Pa.
  void step(State& shell, double dt, const std::vector<Vec<D>>& force, double pressure);

 private:
  ShellModel<D> model_;
  std::vector<Vec<D>> contact_;
  std::vector<double> depth_;  // of the mid-surface behind the contact point
  double longest_step_;
  ShellWorkspace<D> work_;
  std::vector<ShellLoad<D>> load_;
};

extern template class ShellBody<2>;
extern template class ShellBody<3>;

}  // namespace ostium::sph3d
