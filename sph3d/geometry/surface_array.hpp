/// A point array of a surface file, for the points of the surface that was made of it.
///
/// Points are found by their place, since reading joins, drops and caps them; one that the file has not (on a cap) takes the value
/// of the nearest. `length_unit`: m per unit of the file's coordinates. UserError: a file without arrays (STL), an array it has
/// not (with the names it has), of several components, or with values that are not numbers.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

std::vector<double> surface_array(const std::filesystem::path& file, const std::string& name,
                                  double length_unit, const Surface<3>& surface);

}  // namespace ostium::sph3d
