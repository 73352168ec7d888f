/// A shell on the wall of a vessel: particles spread evenly over its surface, then carried outward to the middle of the wall.
///
///   x = c + t/2 n,    A = A_c (1 + k1 t/2)(1 + k2 t/2)
///
///   symbol     meaning                                                                         unit
///   c          contact position: on the surface of the lumen, where blood touches the wall        m
///   n          normal out of the blood, averaged over half a thickness (contact_normal: over the kernel)      -
///   A_c        contact area; the sum is the lateral area of the surface                        m^(D-1)
///   k1, k2     principal curvatures of the surface, positive where the lumen is convex         1/m
///   t          thickness                                                                       m
///   x, A       of the particle of the shell (cloud), on the structural mid-surface                m, m^(D-1)
///   opening    whose end a particle belongs to, -1 between the ends                            -
///   bends      how tightly the wall is bent, and where most                                    -
///   warnings   what the shell does less well than elsewhere, one sentence each
///
/// The wall ends in the planes of the openings, or `beyond` outside them in straight ducts. Particles come in bisection order.
/// Source: docs/theory/shell.md, section "Shells on surfaces". Refused: a spacing coarser than the fluid's, a thickness or
/// stiffness that is not positive, a wall of which more than `bent_share` is bent more tightly than `tightest_bend` allows or any part so
/// tightly that it would cross itself, ends that are not plane, ends so near each other that they hold the whole wall. Not checked: that
/// the surface is closed and does not cut itself.
#pragma once
#include <cstdint>

#include "sph3d/geometry/lumen.hpp"
#include "sph3d/shell/cloud.hpp"
#include "sph3d/shell/wall_quantity.hpp"

namespace ostium::sph3d {

/// What holds the wall near the openings.
///
///   clamped    neither moves nor turns
///   released   widens, but neither moves along the axis of the opening nor turns
///   free       not held
enum class WallEnds { clamped, released, free };

///   symbol          meaning                                                                    unit
///   spacing         dp_s of the shell                                                          m
///   fluid_spacing   dp of the fluid; the shell's may not be coarser                            m
///   thickness       t, constant or varying                                                     m
///   stiffness       factor on the stress of the material, constant or varying                  -
///   clamp_length    how far inside its opening an end is held; 0: 2 h of the fluid and one row, three rows at least    m
///   beyond          how far the shell goes on outside the openings, all of it held             m
///   tightest_bend   largest thickness over the radius of curvature of the mid-surface ...       -
///   bent_share      ... but for this share of the wall, which is named in a warning            -
///   iterations      of the relaxation
struct ShellWallOptions {
  double spacing = 0, fluid_spacing = 0;
  WallQuantity thickness = 0.0, stiffness = 1.0;
  WallEnds ends = WallEnds::clamped;
  double clamp_length = 0, beyond = 0;
  double tightest_bend = 0.5, bent_share = 0.1;
  int iterations = 200;
};

/// Thickness over the radius of curvature of the mid-surface.
///
///   ratio              the largest                                                -
///   radius, thickness  there                                                      m
///   place              there, on the surface of the lumen                         m
///   share              of the wall's area that is bent more tightly than allowed  -
template <int D>
struct WallBends {
  double ratio = 0, radius = 0, thickness = 0, share = 0;
  Vec<D> place = Vec<D>::Zero();
};

template <int D>
struct WallShell {
  ShellCloud<D> cloud;
  std::vector<Vec<D>> contact, contact_normal;
  std::vector<double> contact_area;
  std::vector<std::int32_t> opening;
  WallBends<D> bends;
  Notes warnings;

  std::size_t count() const { return contact.size(); }
};

template <int D>
WallShell<D> shell_of(const Lumen<D>& lumen, const ShellWallOptions& options);

}  // namespace ostium::sph3d
