/// A vessel's wall in the blood's stream: what the blood does to it, and how it moves in answer.
///
///   after the kick      F_i = m (2 P_i B_i grad S + f_i (v_i - v_w)) + the last impact        onto the wall
///   then                the body steps to the end of the acoustic step under F_a = sum_i w_ia F_i and the pressure
///                       p_ref - p_out, and its wall points have moved with v_w = (x_end - x_start) / dt
///   after the density   impact m min(3 u, c) u grad S,  u = 2 max(0, (v_i - v_w).n)     felt in the next kick
///
///   symbol    meaning                                                                  unit
///   p_ref     part of the blood's pressure that the fluid does not carry (PressureDatum)   Pa
///   p_out     pressure of the tissue around the vessel                                     Pa
///   withheld  part of the first load that is let go within `ramp`, so that the wall does not ring       Pa, s
///   body      what the wall is made of, behind the surface that the blood touches: a shell or a solid
///   contact   point on that surface, see the bodies                                      m
///
/// Every force on the wall is the opposite of one on the fluid. Source: docs/theory/walls.md, "Walls that move". Not
/// checked: rho_0 c dt against rho_s t of the wall (see numerics of explicit exchange there).
#pragma once
#include <variant>
#include <vector>

#include "sph3d/step/model.hpp"
#include "sph3d/walls/shell_body.hpp"
#include "sph3d/walls/solid_body.hpp"
#include "sph3d/walls/wall_motion.hpp"

namespace ostium::sph3d {

///   outside_pressure   p_out                                                            Pa
///   rest_pressure      of the blood at which the wall is in equilibrium as it is        Pa
///   ramp               over which the rest of the first load comes                      s
struct SurroundingsOfWall {
  double outside_pressure = 0, rest_pressure = 0, ramp = 0;
};

template <int D>
using WallBody = std::variant<ShellBody<D>, SolidBody<D>>;

template <int D>
class DeformableWall {
 public:
  /// Reach of the fluid's kernel, m.
  DeformableWall(WallBody<D> body, double reach, const SurroundingsOfWall& around);
  /// `contact` of every particle of the shell, in the reference.
  DeformableWall(ShellModel<D> shell, const std::vector<Vec<D>>& contact, double reach,
                 const SurroundingsOfWall& around)
      : DeformableWall(ShellBody<D>(std::move(shell), contact), reach, around) {}

  /// At rest in the reference, before blood of this pressure.
  DeformableWallState<D> rest(double pressure) const;

  /// Asserts that the state is one of this wall.
  void check(const DeformableWallState<D>& state) const;

  /// Where the blood's particles are now: once per advection step.
  void attach(const DeformableWallState<D>& state, const FluidState<D>& fluid);
  void after_kick(const Model<D>& model, const FluidState<D>& fluid);
  void step(DeformableWallState<D>& state, double dt, double reference_pressure);
  void after_density(const Model<D>& model, const FluidState<D>& fluid);
  /// Keeps the last impact by wall points, since the particles' places are theirs for one advection step only.
  void detach(DeformableWallState<D>& state) const;

  const WallMotion<D>& motion() const { return motion_; }
  const WallBody<D>& body() const { return body_; }
  const ShellModel<D>& shell() const { return std::get<ShellBody<D>>(body_).model(); }
  /// Force of the blood on each wall point in the last acoustic step, N, without that of the reference pressure.
  const std::vector<Vec<D>>& forces() const { return force_; }
  std::size_t count() const { return force_.size(); }  ///< contact points
  std::vector<WallPoint<D>> points_at_rest() const;
  std::vector<WallPoint<D>> points(const DeformableWallState<D>& state) const;

 private:
  double withheld(const DeformableWallState<D>& state, double time) const;

  WallBody<D> body_;
  SurroundingsOfWall around_;
  WallMotion<D> motion_;
  std::vector<Vec<D>> on_wall_, impact_;  // F_i of each place, and the part that is felt in the next kick
  std::vector<Vec<D>> force_;
};

extern template class DeformableWall<2>;
extern template class DeformableWall<3>;

}  // namespace ostium::sph3d
