/// Triangles as a file holds them, before anything is checked. Internal to geometry/.
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

struct Soup {
  std::vector<Vec3> points;
  std::vector<Triangle> facets;
  std::vector<int> face_id;              ///< per facet; empty when the file has no labels
  std::map<int, std::string> face_name;  ///< of those ids that have one
  std::vector<int> cap;                  ///< per facet: the open end it closes, else -1; empty when none does
  Notes notes;
};

/// Coordinates in the units of the file. Throws UserError on anything that is not a readable surface.
Soup read_stl(const std::filesystem::path& file);
Soup read_vtp(const std::filesystem::path& file);

}  // namespace ostium::sph3d
