/// A closed boundary of a vessel: triangles (D = 3) or segments (D = 2), oriented outward.
///
///   area vector of a facet   A n = (b - a) x (c - a) / 2      (D = 3)
///                            A n = (b_y - a_y, a_x - b_x)      (D = 2, length times normal)
///   enclosed volume          V = (1/D) sum_f x_f . A_f n_f     (divergence theorem, x_f the facet centroid)
///
///   points   m    corners, shared by the facets that meet there
///   facets   -    corner indices; counter-clockwise seen from outside (2D: interior on the left of a -> b)
///   label    -    per facet: -1 wall, k >= 0 the opening k of the lumen
///
/// Not checked here: closedness, orientation and self-intersection; read_lumen() and polygon_lumen() do that.
#pragma once
#include <array>
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
struct Surface {
  std::vector<Vec<D>> points;
  std::vector<std::array<int, D>> facets;
  std::vector<int> label;
};

/// Outward normal times area (2D: length) of the facet f.
template <int D>
Vec<D> area_vector(const Surface<D>& surface, int f);

template <int D>
Vec<D> centroid(const Surface<D>& surface, int f);

/// Enclosed volume, m3 (2D: area, m2); negative when the normals point inward.
template <int D>
double volume(const Surface<D>& surface);

/// Area of all facets that carry `label`, m2 (2D: length, m).
template <int D>
double area(const Surface<D>& surface, int label);

template <int D>
struct Bounds {
  Vec<D> lower, upper;
  Vec<D> extent() const { return upper - lower; }
};

template <int D>
Bounds<D> bounds(const std::vector<Vec<D>>& points);

}  // namespace ostium::sph3d
