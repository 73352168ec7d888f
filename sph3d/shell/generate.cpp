#include "sph3d/shell/generate.hpp"

#include <cmath>

#include "core/error.hpp"
#include "sph3d/neighbours/order.hpp"
#include "sph3d/shell/bends.hpp"
#include "sph3d/shell/circumference.hpp"
#include "sph3d/shell/ends.hpp"
#include "sph3d/shell/lateral.hpp"
#include "sph3d/shell/surface_bending.hpp"
#include "sph3d/shell/surface_points.hpp"

namespace ostium::sph3d {

namespace {

void check_options(const ShellWallOptions& o) {
  if (!(o.spacing > 0.0)) user_error("the shell spacing is {:g} m; it has to be positive", o.spacing);
  if (!(o.fluid_spacing > 0.0))
    user_error("the fluid spacing is {:g} m; it has to be positive", o.fluid_spacing);
  if (o.spacing > o.fluid_spacing * (1.0 + 1e-9))
    user_error(
        "the shell spacing of {:g} m is coarser than the fluid's, {:g} m: blood would leak between its "
        "particles. "
        "Take {:g} m or less",
        o.spacing, o.fluid_spacing, o.fluid_spacing);
  if (o.ends == WallEnds::clamped && o.clamp_length > 0.0 && o.clamp_length < 3.0 * o.spacing)
    user_error(
        "the clamped ends of the wall are {:g} m long, less than three rows of particles; take {:g} m or "
        "more",
        o.clamp_length, 3.0 * o.spacing);
  if (!(o.clamp_length >= 0.0) || !(o.beyond >= 0.0))
    user_error("the lengths of the wall's ends are {:g} m and {:g} m; they must not be negative",
               o.clamp_length, o.beyond);
}

template <int D>
SurfacePoints<D> ordered(const SurfacePoints<D>& p) {
  SurfacePoints<D> sorted;
  for (const auto k : bisection_order<D>(p.position)) {
    sorted.position.push_back(p.position[k]), sorted.normal.push_back(p.normal[k]);
    sorted.area.push_back(p.area[k]);
  }
  return sorted;
}

/// Points on the wall, continued in ducts where it goes on.
template <int D>
SurfacePoints<D> points_on(const Lumen<D>& lumen, const ShellWallOptions& o) {
  std::vector<Rim<D>> rims;
  for (const auto& opening : lumen.openings) rims.emplace_back(opening, o.beyond);
  const auto surface = o.beyond > 0.0 ? extended(lumen, o.beyond).surface : lumen.surface;
  return ordered(surface_points(lateral(surface), rims, o.spacing, o.iterations));
}

/// From the surface of the lumen to the middle of the wall.
template <int D>
ShellCloud<D> mid_surface(const SurfacePoints<D>& p, const std::vector<Vec<D>>& normal,
                          const std::vector<Curvatures<D>>& curvature, const std::vector<double>& thickness) {
  ShellCloud<D> cloud;
  cloud.normal = normal, cloud.thickness = thickness;
  for (std::size_t a = 0; a < normal.size(); ++a) {
    double area = p.area[a];
    for (const double k : curvature[a]) area *= 1.0 + 0.5 * k * thickness[a];
    cloud.position.push_back(p.position[a] + 0.5 * thickness[a] * normal[a]);
    cloud.area.push_back(area);
  }
  return cloud;
}

}  // namespace

template <int D>
WallShell<D> shell_of(const Lumen<D>& lumen, const ShellWallOptions& options) {
  check_options(options);
  check_plane_ends(lumen, options.spacing);
  const auto points = points_on(lumen, options);
  const auto thickness = values_at(options.thickness, points.position, lumen, "the thickness of the wall");
  const auto stiffness =
      values_at(options.stiffness, points.position, lumen, "the stiffness factor of the wall");
  const SurfaceAverage<D> average(points, options.spacing);
  WallShell<D> shell;
  shell.contact = points.position, shell.contact_area = points.area;
  shell.contact_normal = contact_normals(points, average);
  const auto normal = wall_normals(points, average, shell.contact_normal, thickness, options.spacing);
  const auto S = bending(points, average.pairs(), normal, options.spacing);
  const auto curvature = principal_curvatures<D>(S);
  shell.bends = bends_of(points, curvature, thickness, options.tightest_bend);
  check_bends(shell.bends, options, shell.warnings);
  shell.opening = ends_of(points, lumen, options);
  check_free_rows(points, shell.opening, lumen, options);
  shell.cloud = mid_surface<D>(points, normal, curvature, thickness);
  shell.cloud.stiffness = stiffness;
  if constexpr (D == 3)
    shell.cloud.circumference = circumference(average, normal, S, thickness, options.spacing);
  hold_ends(shell.cloud, shell.opening, lumen, options.ends);
  return shell;
}

template WallShell<2> shell_of(const Lumen<2>&, const ShellWallOptions&);
template WallShell<3> shell_of(const Lumen<3>&, const ShellWallOptions&);

}  // namespace ostium::sph3d
