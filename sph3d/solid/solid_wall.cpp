#include "sph3d/solid/solid_wall.hpp"

#include "core/error.hpp"
#include "sph3d/shell/ends.hpp"

namespace ostium::sph3d {

namespace {

void check_options(const SolidWallOptions& o) {
  if (o.spacing > o.fluid_spacing * (1.0 + 1e-9))
    user_error(
        "the spacing of the solid wall, {:g} m, is coarser than the fluid's, {:g} m: blood would leak "
        "between "
        "its particles. Take {:g} m or less",
        o.spacing, o.fluid_spacing, o.fluid_spacing);
  if (o.clamp_length < 0.0 || (o.clamp_length > 0.0 && o.clamp_length < 3.0 * o.spacing))
    user_error(
        "the clamped ends of the wall are {:g} m long, less than three rows of particles; take {:g} m or "
        "more",
        o.clamp_length, 3.0 * o.spacing);
}

}  // namespace

template <int D>
WallCloud<D> solid_of(const Lumen<D>& lumen, const SolidWallOptions& o) {
  check_options(o);
  check_plane_ends(lumen, o.spacing);
  WallCloud<D> wall = wall_cloud(lumen, o.thickness, o.spacing);
  SurfacePoints<D> points;
  points.position = wall.contact;
  for (const auto a : wall.inner.particle) points.normal.push_back(wall.normal[a]);
  const ShellWallOptions ends{
      .spacing = o.spacing, .fluid_spacing = o.fluid_spacing, .clamp_length = o.clamp_length};
  const auto opening = ends_of(points, lumen, ends);
  check_free_rows(points, opening, lumen, ends);
  for (const auto k : wall.column) wall.solid.held.push_back(opening[k] < 0 ? 0 : hold_all);
  return wall;
}

template WallCloud<2> solid_of(const Lumen<2>&, const SolidWallOptions&);
template WallCloud<3> solid_of(const Lumen<3>&, const SolidWallOptions&);

}  // namespace ostium::sph3d
