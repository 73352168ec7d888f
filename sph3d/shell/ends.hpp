/// What holds a wall near its openings, and what is refused there. Internal to shell/.
///
///   opening   whose end a point belongs to, -1 between the ends
#pragma once
#include <cstdint>

#include "sph3d/shell/generate.hpp"
#include "sph3d/shell/surface_points.hpp"

namespace ostium::sph3d {

/// How far inside its opening an end reaches, m.
double end_length(const ShellWallOptions& options);

/// Refuses rims that are further from their plane than a quarter of the spacing.
template <int D>
void check_plane_ends(const Lumen<D>& lumen, double spacing);

/// The nearest of the openings within whose end a point lies, and to whose rim it is joined within that end.
template <int D>
std::vector<std::int32_t> ends_of(const SurfacePoints<D>& points, const Lumen<D>& lumen,
                                  const ShellWallOptions& options);

/// Refuses clamps with fewer than three rows of free points between them.
template <int D>
void check_free_rows(const SurfacePoints<D>& points, const std::vector<std::int32_t>& opening,
                     const Lumen<D>& lumen, const ShellWallOptions& options);

/// Support and axis of the cloud.
template <int D>
void hold_ends(ShellCloud<D>& cloud, const std::vector<std::int32_t>& opening, const Lumen<D>& lumen,
               WallEnds ends);

}  // namespace ostium::sph3d
