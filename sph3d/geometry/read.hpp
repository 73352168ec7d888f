/// A vessel surface from a file: read, repaired, checked, its openings found and named.
///
///   formats   STL (ASCII; binary, also when its header begins with "solid"), VTP (polygons; ModelFaceID or
///   CapID) repairs   coincident corners welded, degenerate and doubled triangles dropped, inward and
///   inconsistent
///             normals turned, small leftover shells dropped; each leaves a sentence in Lumen::repairs
///   refused   unreadable or truncated files, open ends (unless cap_open_ends), non-manifold edges, several
///   shells,
///             no opening, a choice of opening that matches nothing, two names on one opening
///
///   length_unit    m per unit of the file
///   cap_open_ends  join open edges that nearly coincide, close every open end with a flat cap, an opening
///   then largest        rank by area, 1 the largest;  nearest  m, the opening whose centre is nearest label
///   face id, or name of a face (.facenames beside a VTP, solids of an ASCII STL) where          put before
///   the sentence of an error about this choice, such as "case.yaml:7:5: "
///
/// Openings come from the labels of the file where it has any, otherwise from flat regions with a sharp convex
/// rim. They are sorted by falling area. Triangles that cut one another are told in Lumen::repairs, not mended.
#pragma once
#include <filesystem>
#include <optional>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

struct OpeningChoice {
  std::string name;
  std::optional<int> largest = {};
  std::optional<Vec3> nearest = {};
  std::optional<std::string> label = {};
  std::string where = {};
};

struct SurfaceOptions {
  std::filesystem::path file;
  double length_unit = 1;
  bool cap_open_ends = false;
  std::vector<OpeningChoice> openings = {};
};

Lumen<3> read_lumen(const SurfaceOptions& options);

/// The openings as a table: rank, name, area, diameter, centre, normal, face.
std::string describe(const Lumen<3>& lumen);

}  // namespace ostium::sph3d
