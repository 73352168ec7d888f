/// The walls of a 2D vessel as stretches from one opening to the next, and points that divide them evenly.
///
/// A stretch is a list of facets, each beginning where the last one ends; a wall without openings is one closed stretch. Only
/// facets labelled -1 belong to it. About length/spacing points on each stretch, at least one, in the middle of equal parts,
/// whatever the length of its segments; `area` is the length of a part.
#pragma once
#include "sph3d/geometry/sample.hpp"

namespace ostium::sph3d {

std::vector<std::vector<int>> stretches(const Surface<2>& surface);

std::vector<WallPoint<2>> spread_evenly(const Surface<2>& surface, double spacing);

}  // namespace ostium::sph3d
