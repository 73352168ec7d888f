/// One step of a solid: leapfrog in the form drift - kick - drift.
///
///   u += dt/2 v;    rho0 V a = - d Pi / du + damping + loads;    v += dt a;    u += dt/2 v
///
/// Pi is the elastic energy as the particles see it (solid_report.hpp), so that without damping the scheme is symplectic:
/// energy does not drift. Components that are held keep their velocity: zero where clamped, else what the caller prescribes.
///
///   loads.force      external force per particle, constant over the step (empty: none)      N
///   loads.patches    pressures on parts of the surface, along the deformed normals           Pa
///   loads.tractions  forces on points of the surface                                         N
///
/// Source: docs/theory/solid.md. The same bits for any number of threads. Thrown by advance(): NumericsError when a velocity is
/// no longer finite.
#pragma once
#include "sph3d/solid/solid_state.hpp"

namespace ostium::sph3d {

/// A part of the surface, each piece above a particle: p J F^-T A acts against the outward area A of the reference. The particle
/// lies at some depth below it; the force does its work on the displacement u_a + depth H_a n of the surface, H = F - I, so that
/// neighbours share it. Without that the error falls only in proportion to the spacing.
template <int D>
struct PressurePatch {
  std::vector<std::int32_t> particle;
  std::vector<Vec<D>> area;  ///< outward normal times area, m2 (2D: m)
  double depth = 0;          ///< of the particles below the surface, m: half a spacing
  double pressure = 0;       ///< Pa
};

/// Forces of given direction on points of the surface, likewise.
template <int D>
struct TractionPatch {
  std::vector<std::int32_t> particle;
  std::vector<Vec<D>> force;       ///< N (2D: N/m)
  std::vector<Vec<D>> to_surface;  ///< from the particle, reference, m
};

template <int D>
struct SolidLoads {
  std::vector<Vec<D>> force = {};
  std::vector<PressurePatch<D>> patches = {};
  std::vector<TractionPatch<D>> tractions = {};
  double mass_damping = 0;  ///< - mass_damping v on every particle, to find states of rest, 1/s
};

/// Arrays that live as long as the run but are no state.
template <int D>
struct SolidWorkspace {
  std::vector<double> displacement, stress, force;
  std::vector<Vec<D>> load;
};

template <int D>
void advance(const SolidModel<D>& model, SolidState<D>& state, const SolidLoads<D>& loads, double dt,
             SolidWorkspace<D>& work);

/// 0.6 min(s h/(c + |v|), sqrt(h/|a|)) with the speed c of pressure waves and a of the last step; s <= 1 takes the damping into
/// account. The limit lies between 0.7 and 1.1, by the order of the cloud (docs/theory/solid.md).
template <int D>
double stable_step(const SolidModel<D>& model, const SolidState<D>& state, const SolidWorkspace<D>& work,
                   double courant = 0.6);

/// F of one particle, by the plain sum.
template <int D>
Mat<D> deformation_gradient(const SolidModel<D>& model, const std::vector<Vec<D>>& displacement,
                            std::size_t a);

}  // namespace ostium::sph3d
