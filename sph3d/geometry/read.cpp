#include "sph3d/geometry/read.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/choose.hpp"
#include "sph3d/geometry/find_openings.hpp"
#include "sph3d/geometry/repair.hpp"
#include "sph3d/geometry/self_intersection.hpp"

namespace ostium::sph3d {
namespace {

std::string extension(const std::filesystem::path& file) {
  auto ext = file.extension().string();
  std::transform(ext.begin(), ext.end(), ext.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ext;
}

Soup read_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    user_error("{}: no such file; relative paths start at the folder of the case", file.string());
  if (!std::filesystem::is_regular_file(file, ignored)) user_error("{}: not a file", file.string());
  if (extension(file) == ".stl") return read_stl(file);
  if (extension(file) == ".vtp") return read_vtp(file);
  user_error("{}: surfaces are read from .stl and .vtp files, not from \"{}\"", file.string(),
             extension(file));
}

/// A forgotten or wrong unit makes a vessel of a size no body has.
void note_size(Soup& soup) {
  const double across = bounds(soup.points).extent().norm();
  if (across < 1e-3 || across > 3)
    soup.notes.push_back(
        fmt::format("the vessel is {} long from corner to corner; check `length_unit`", size(across)));
}

Soup repaired(const SurfaceOptions& options) {
  Soup soup = read_file(options.file);
  for (auto& x : soup.points) x *= options.length_unit;
  note_size(soup);
  weld(soup);
  if (options.cap_open_ends) join_open_edges(soup);
  if (soup.facets.empty()) user_error("all triangles of the surface are degenerate");
  check_manifold(soup);
  orient_consistently(soup);
  close_open_ends(soup, options.cap_open_ends);
  settle_shells(soup);
  return soup;
}

/// Particles follow the sign of the distance, which means nothing where the wall cuts itself.
void note_self_intersections(const Surface<3>& surface, Notes& notes) {
  const auto pairs = self_intersections(surface);
  if (pairs.empty()) return;
  notes.push_back(
      fmt::format("{} pairs of triangles cut one another, the first at {}; look at the vessel there",
                  pairs.size(), place(centroid(surface, pairs.front().first))));
}

Lumen<3> make_lumen(const SurfaceOptions& options) {
  Soup soup = repaired(options);
  Lumen<3> lumen;
  lumen.surface.points = soup.points;
  lumen.surface.facets = soup.facets;
  lumen.openings = find_openings(lumen.surface, soup);
  const auto uneven = uneven_ends(lumen.surface, soup, options.file.filename().string());
  if (lumen.openings.empty() && !uneven.empty() && !uneven.front().label.empty()) refuse(uneven.front());
  if (lumen.openings.empty())
    user_error(
        "the surface is closed and has no opening: no face is labelled and flat, and no flat region has a "
        "sharp rim{}; "
        "cut the vessel's ends by planes, or label its faces (ModelFaceID)",
        uneven.empty() ? "" : " (" + uneven.front().text + ")");
  name_openings(lumen.openings, options.openings, uneven);
  lumen.volume = volume(lumen.surface);
  lumen.wall_area = area(lumen.surface, -1);
  lumen.repairs = std::move(soup.notes);
  for (const auto& end : uneven) lumen.repairs.push_back(end.text + "; it counts as wall");
  note_self_intersections(lumen.surface, lumen.repairs);
  return lumen;
}

}  // namespace

Lumen<3> read_lumen(const SurfaceOptions& options) {
  OSTIUM_ASSERT(options.length_unit > 0, "length unit {} m", options.length_unit);
  try {
    return make_lumen(options);
  } catch (const UserError& error) {
    const std::string text = error.what(), file = options.file.string();
    const bool told = text.starts_with(file) ||
                      std::any_of(options.openings.begin(), options.openings.end(),
                                  [&](auto& o) { return !o.where.empty() && text.starts_with(o.where); });
    if (told) throw;
    throw UserError(file + ": " + text);
  }
}

std::string describe(const Lumen<3>& lumen) {
  std::string text = fmt::format("lumen {:.4g} mL, wall {:.4g} cm2, {} triangles\n", 1e6 * lumen.volume,
                                 1e4 * lumen.wall_area, lumen.surface.facets.size());
  text += table(lumen.openings);
  for (const auto& note : lumen.repairs) text += "  note: " + note + "\n";
  return text;
}

}  // namespace ostium::sph3d
