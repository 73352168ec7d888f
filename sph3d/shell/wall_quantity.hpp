/// A positive number that is the same all over the wall, or varies: thickness, stiffness.
///
///   double          everywhere
///   list            one value per point of the surface, linear over each facet
///   FromOpening     linear in the distance from an opening's rim: `at_opening` there, `away` from `length` on
///
/// The distance is the straight one to the rim, not the way along the wall. Refused: values that are not positive, a list of
/// another length than the points of the surface, an opening the vessel has not.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

struct FromOpening {
  std::string opening;
  double at_opening, away;
  double length;  ///< m
};

using WallQuantity = std::variant<double, std::vector<double>, FromOpening>;

/// Its values at points of the wall. `name` with its unit begins the sentence of a refusal: "the thickness of the wall".
template <int D>
std::vector<double> values_at(const WallQuantity& quantity, const std::vector<Vec<D>>& points,
                              const Lumen<D>& lumen, const char* name);

}  // namespace ostium::sph3d
