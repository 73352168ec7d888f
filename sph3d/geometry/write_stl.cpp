#include "sph3d/geometry/write_stl.hpp"

#include <cstring>
#include <fstream>

#include "core/error.hpp"

namespace ostium::sph3d {

void write_stl(const Surface<3>& surface, const std::filesystem::path& file, double length_unit) {
  std::string bytes(80, '\0');
  const std::string title = "Ostium vessel surface";
  std::copy(title.begin(), title.end(), bytes.begin());
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(std::uint32_t(surface.facets.size()));
  for (int f = 0; f < int(surface.facets.size()); ++f) {
    for (float c : Eigen::Vector3f(area_vector(surface, f).normalized().cast<float>())) append(c);
    for (int v : surface.facets[f])
      for (float c : Eigen::Vector3f((surface.points[v] / length_unit).cast<float>())) append(c);
    append(std::uint16_t(0));
  }
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), std::streamsize(bytes.size()));
  out.close();
  if (!out) user_error("{}: cannot be written", file.string());
}

}  // namespace ostium::sph3d
