/// The wall of a lumen moved outward along its normals: what lies a given distance further out.
///
///   corner i moves by d_i with  n_f . d_i = distance  for the wall facets f around it, in the sense of least squares weighted by
///   area, and  n_o . d_i = 0  where it lies on the rim of the opening o
///
///   distance   m   positive outward, negative into the lumen
///
/// Facets keep their order, so that facet f of the result lies over facet f of the lumen; openings keep their planes. Not
/// checked: that the result does not cut itself, as it does where the wall is bent more tightly than the distance; trim what is
/// nearer to the lumen than that.
#pragma once
#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

template <int D>
Lumen<D> offset(const Lumen<D>& lumen, double distance);

}  // namespace ostium::sph3d
