/// Points and surfaces with named fields as VTK files (.vtp, binary, compressed, single precision).
///
///   points   m   D = 2 is written with z = 0
///   Field    -   one scalar, vector or symmetric tensor (xx yy zz xy yz xz) per point or facet: `components` 1, 2, 3 or 6
///                (2 is written as 3)
///
/// Files are written beside their final name and then renamed: whoever reads a series while a run goes on never
/// sees half a file. Throws UserError when the file cannot be written. Not checked: NaN in the values.
#pragma once
#include <filesystem>
#include <span>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

struct Field {
  std::string name;
  int components = 1;
  std::vector<float> values;  ///< point by point
};

Field field(std::string name, std::span<const double> values);
Field field(std::string name, std::span<const float> values);
template <int D>
Field field(std::string name, std::span<const Vec<D>> values);

template <int D>
void write_particles_vtp(const std::filesystem::path& file, std::span<const Vec<D>> points,
                         std::span<const Field> fields);

/// The opening number of each facet (-1 wall) is always added, as `opening`.
template <int D>
void write_surface_vtp(const std::filesystem::path& file, const Surface<D>& surface,
                       std::span<const Field> point_fields, std::span<const Field> facet_fields = {});

}  // namespace ostium::sph3d
