/// Which triangles meet at which edge. Internal to geometry/.
#pragma once
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace ostium::sph3d {

using Triangle = std::array<int, 3>;

/// One side of a triangle: from corner `slot` to the next; lower < upper are its points.
struct EdgeUse {
  int lower, upper, facet, slot;
};

/// All sides, those of one edge next to each other, in a fixed order.
std::vector<EdgeUse> edge_uses(std::span<const Triangle> facets);

/// Calls visit(span of the uses of one edge) for every edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit visit) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[j].lower == uses[i].lower && uses[j].upper == uses[i].upper) ++j;
    visit(std::span<const EdgeUse>(&uses[i], j - i));
  }
}

/// The facet beyond each side; -1 where the edge is not shared by exactly two.
std::vector<Triangle> neighbours(std::span<const Triangle> facets);

/// Chains directed edges (from, to) into closed loops of points; at a branching point any continuation is
/// taken.
std::vector<std::vector<int>> loops(std::vector<std::pair<int, int>> edges);

/// Whether the triangle runs along its side `slot` from the lower to the upper point.
inline bool forward(std::span<const Triangle> facets, const EdgeUse& use) {
  return facets[use.facet][use.slot] == use.lower;
}

}  // namespace ostium::sph3d
