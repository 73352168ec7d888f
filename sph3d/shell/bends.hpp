/// Whether a wall is bent too tightly for a shell of its thickness. Internal to shell/.
///
///   ratio = t / R,   R = |1/k + t/2|  the radius of the mid-surface, k a principal curvature of the surface of the lumen
///
/// ratio 2: one face of the wall comes to a point (inside a tube of no radius, outside a valley of radius t).
#pragma once
#include "sph3d/shell/generate.hpp"
#include "sph3d/shell/surface_bending.hpp"

namespace ostium::sph3d {

template <int D>
std::vector<Curvatures<D>> principal_curvatures(const std::vector<Bending<D>>& bending);

/// `allowed`: ratio beyond which area counts as bent too tightly.
template <int D>
WallBends<D> bends_of(const SurfacePoints<D>& points, const std::vector<Curvatures<D>>& curvature,
                      const std::vector<double>& thickness, double allowed);

/// UserError where too much is bent too tightly; a warning where little is.
template <int D>
void check_bends(const WallBends<D>& bends, const ShellWallOptions& options, Notes& warnings);

}  // namespace ostium::sph3d
