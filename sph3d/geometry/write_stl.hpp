/// Writes a surface as binary STL (single precision, no labels).
///
///   length_unit   m per unit of the file
#pragma once
#include <filesystem>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

void write_stl(const Surface<3>& surface, const std::filesystem::path& file, double length_unit = 1e-3);

}  // namespace ostium::sph3d
