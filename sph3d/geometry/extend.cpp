#include <map>

#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {
namespace {

/// The sides of the opening's facets that border on something else, in the sense of its facets.
std::vector<std::pair<int, int>> rim(const Surface<3>& surface, int label) {
  std::vector<std::pair<int, int>> sides;
  for_each_edge(edge_uses(surface.facets), [&](std::span<const EdgeUse> uses) {
    const EdgeUse* mine = nullptr;
    int count = 0;
    for (const auto& use : uses)
      if (surface.label[use.facet] == label) mine = &use, ++count;
    if (count != 1) return;
    if (forward(surface.facets, *mine))
      sides.emplace_back(mine->lower, mine->upper);
    else
      sides.emplace_back(mine->upper, mine->lower);
  });
  return sides;
}

/// Moves the opening's points (copies of them) and returns old -> new.
template <int D>
std::map<int, int> move_opening(Surface<D>& surface, const Opening<D>& opening, int label, double length) {
  std::map<int, int> moved;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (surface.label[f] != label) continue;
    for (int& v : surface.facets[f]) {
      const auto [at, is_new] = moved.try_emplace(v, int(surface.points.size()));
      if (is_new) {
        const Vec<D> x = surface.points[v];
        surface.points.push_back(x + (length - (x - opening.centre).dot(opening.normal)) * opening.normal);
      }
      v = at->second;
    }
  }
  return moved;
}

template <int D>
void add_wall(Surface<D>& surface, std::array<int, D> facet) {
  surface.facets.push_back(facet);
  surface.label.push_back(-1);
}

void add_duct(Surface<3>& surface, const Opening<3>& opening, int label, double length) {
  const auto sides = rim(surface, label);
  auto moved = move_opening(surface, opening, label, length);
  for (const auto& [a, b] : sides) {
    add_wall<3>(surface, {a, b, moved.at(b)});
    add_wall<3>(surface, {a, moved.at(b), moved.at(a)});
  }
}

void add_duct(Surface<2>& surface, const Opening<2>& opening, int label, double length) {
  std::map<int, int> balance;  // +1 where the opening begins, -1 where it ends
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (surface.label[f] == label) ++balance[surface.facets[f][0]], --balance[surface.facets[f][1]];
  auto moved = move_opening(surface, opening, label, length);
  for (const auto& [point, sign] : balance) {
    if (sign > 0) add_wall<2>(surface, {point, moved.at(point)});
    if (sign < 0) add_wall<2>(surface, {moved.at(point), point});
  }
}

}  // namespace

template <int D>
Lumen<D> extended(const Lumen<D>& lumen, double length) {
  Lumen<D> longer = lumen;
  for (int k = 0; k < int(lumen.openings.size()); ++k) add_duct(longer.surface, lumen.openings[k], k, length);
  longer.volume = volume(longer.surface);
  longer.wall_area = area(longer.surface, -1);
  return longer;
}

template Lumen<2> extended(const Lumen<2>&, double);
template Lumen<3> extended(const Lumen<3>&, double);

}  // namespace ostium::sph3d
