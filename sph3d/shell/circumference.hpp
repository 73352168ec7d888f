/// The direction around a vessel at every point of its wall, from which the angles of fibres are measured. Internal to shell/.
///
///   q_a = (k2 - k1)/(|k1| + |k2|) (c (x) c - a (x) a),    Q = <<...<q>>>,    circumference = eigenvector of the largest eigenvalue of Q
///
///   k1 <= k2    principal curvatures of the wall, with their sign             1/m
///   c, a        their directions: c of k2                                     -
///   <...>       averages over the surface, each laid into the tangent plane of its point, over a length of t (2 dp at least)
///
/// Exact where the axis is straight or an arc and the section round: there c is tangent to the section. The larger curvature is taken
/// with its sign, so that the inside of a bend, saddle-shaped, gives the same. Where both are alike (a bulge, a branching) q fades and the
/// neighbours speak. Source: docs/theory/shell.md, "Shells on surfaces".
#pragma once
#include "sph3d/shell/surface_bending.hpp"

namespace ostium::sph3d {

/// Unit tangents, either way round.
std::vector<Vec3> circumference(const SurfaceAverage<3>& average, const std::vector<Vec3>& normal,
                                const std::vector<Bending<3>>& bending, const std::vector<double>& thickness,
                                double spacing);

}  // namespace ostium::sph3d
