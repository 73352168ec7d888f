/// Everything about a vessel that does not change while the blood flows.
///
///   symbol            meaning                                                              unit
///   dp                particle spacing; h = 1.3 dp                                         m
///   density           rho0                                                                 kg/m3
///   viscosity         nu = eta / rho0                                                      m2/s
///   sound_speed       c                                                                    m/s
///   reference_speed   floor of the velocity in the advection time step                     m/s
///   advection_cfl     share of h a particle may move in an advection step (0.25)           -
///   acoustic_cfl      share of h sound may travel in an acoustic step (0.6)                -
///   shift             zeta of the transport shift (0.2)                                    -
///   limiter           of the pressure dissipation (3)                                      -
///   friction_limit    largest ratio in the velocity continued through the wall (4), see HalfSpace   -
///   density_relaxation  theta: share of the number density in the re-initialisation (1)    -
///   gravity           body acceleration                                                    m/s2
///
/// Source: docs/theory/fluid.md.
#pragma once
#include <vector>

#include "sph3d/geometry/lumen.hpp"
#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/openings/duct.hpp"
#include "sph3d/openings/profile.hpp"
#include "sph3d/openings/slice.hpp"
#include "sph3d/walls/half_space.hpp"
#include "sph3d/walls/wall_field.hpp"

namespace ostium::sph3d {

template <int D>
struct FluidOptions {
  double dp = 0, density = 1060, viscosity = 0, sound_speed = 0, reference_speed = 0;
  double advection_cfl = 0.25, acoustic_cfl = 0.6, shift = 0.2, limiter = 3.0, density_relaxation = 1.0;
  double friction_limit = 4.0;  // of the velocity continued through the wall, see HalfSpace
  int reorder_every = 16;       // advection steps
  int most_acoustic_steps = 8;  // in one advection step, during which neighbours are frozen
  Vec<D> gravity = Vec<D>::Zero();
};

/// What an opening does: impose a flow with its profile, or answer to a pressure law.
struct OpeningRole {
  bool flow_driven = false;
  Profile profile = Profile::parabolic;
};

template <int D>
struct Model {
  Model(const Lumen<D>& lumen, const FluidOptions<D>& options, std::vector<OpeningRole> roles);

  double reach() const { return kernel.reach(); }
  /// rho over rho0 for the density deviation psi: 1 at the pressure of the start, when particles take up their volume V.
  double density_ratio(double psi) const { return (1.0 + psi) * rest_volume; }

  FluidOptions<D> options;
  Lumen<D> lumen;   // as read
  Lumen<D> domain;  // with its ducts
  Wendland<D> kernel;
  HalfSpace<D> half_space;
  SignedDistance<D> distance;        // from the wall; ducts go on beyond their outer faces
  WallField<D> wall;                 // likewise
  std::vector<OpeningRole> roles;    // of each opening
  std::vector<Duct<D>> ducts;        // likewise
  std::vector<Slice<D>> slices;      // likewise
  std::vector<FlowShape<D>> shapes;  // likewise
  Vec<D> origin;                     // of the local coordinates
  double particle_volume;            // dp^D
  double number_density;             // sum W V of undisturbed fluid (density is measured against it)
  double rest_volume = 1;            // of a particle at the pressure of the start, over that at pressure 0
  double settling_time;              // s, in which the scale of the kernel sums follows the counted content
};

extern template struct Model<2>;
extern template struct Model<3>;

}  // namespace ostium::sph3d
