/// From loose triangles to a manifold, outward oriented surface. Internal to geometry/; lengths in m.
#pragma once
#include "sph3d/geometry/soup.hpp"

namespace ostium::sph3d {

/// Merges coincident corners; drops degenerate and doubled triangles. Corners that differ, by however little, are left to
/// join_open_edges, which a case asks for.
void weld(Soup& soup);

/// Merges corners of open edges that nearly coincide: parts written with different rounding.
void join_open_edges(Soup& soup);

/// Refuses edges shared by more than two triangles, with the place of the first.
void check_manifold(const Soup& soup);

/// Gives all triangles of a shell the same sense; refuses surfaces that have none (a Moebius band).
void orient_consistently(Soup& soup);

/// Shell number of each triangle (triangles are joined by edges), numbered from 0.
std::vector<int> shells(const Soup& soup);

/// For closed soups: turns inward shells outward, drops leftover shells, refuses several large ones.
void settle_shells(Soup& soup);

/// Keeps the facets for which keep[f] holds.
void keep_facets(Soup& soup, const std::vector<char>& keep);

void drop_unused_points(Soup& soup);

/// Refuses open ends, naming each with its place and size, or closes them: ends by caps (Soup::cap), holes
/// smaller than 1 % of the largest end by wall.
void close_open_ends(Soup& soup, bool cap_open_ends);

/// "(12.3, 4.5, -6) mm"
std::string place(const Vec3& x);
/// "3.2 mm"
std::string size(double length);

}  // namespace ostium::sph3d
