/// Of many samples of a surface those that stand apart: the one that is crowded most is taken away until `keep` are left.
///
///   crowding = sum over the others nearer than d of (1 - r/d)^8,   d = 2 sqrt(A / (2 sqrt(3) keep))
///
///   d   spacing of the densest lattice of `keep` points on the area A     m
///
/// Source: Yuksel 2015, Sample elimination for generating Poisson disk sample sets. Internal to shell/.
#pragma once
#include "sph3d/shell/surface_pairs.hpp"

namespace ostium::sph3d {

/// Which samples stay, in their order.
std::vector<std::int32_t> eliminate(const std::vector<Vec3>& position, const std::vector<Vec3>& normal,
                                    const std::vector<Rim<3>>& rims, std::size_t keep, double area);

}  // namespace ostium::sph3d
