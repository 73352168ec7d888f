/// Where the particles of a vessel start before they are relaxed.
///
/// Whole cells of a cubic lattice of spacing dp get one point each. The cells that the wall or the layers of an opening
/// cut add up their shares of volume along a path through all of them, and each whole unit gets a point where it has the
/// most room. Every part of the vessel, and the narrowest branch, so holds the number its volume asks for: relaxation
/// evens out the spacing of neighbours quickly, but carries particles along a branch very slowly.
///
///   wanted   points to make, exactly
///   layers   points that stand already, behind the outer faces of the openings, m
///
/// Not checked: that the vessel is at least a few spacings wide.
#pragma once
#include <vector>

#include "sph3d/step/model.hpp"

namespace ostium::sph3d {

template <int D>
std::vector<Vec<D>> inner_points(const Model<D>& model, std::size_t wanted,
                                 const std::vector<Vec<D>>& layers);

}  // namespace ostium::sph3d
