#include "sph3d/geometry/uneven_ends.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/pseudo_normals.hpp"
#include "sph3d/geometry/repair.hpp"

namespace ostium::sph3d {
namespace {

const double sharp = std::cos(pi / 6);  // 30 degrees: a rim

/// Parts between sharp edges, as keys of facets; openings are left out.
std::vector<int> between_sharp_edges(const SurfaceTopology& t) {
  std::vector<int> key(t.surface.facets.size(), -1);
  int number = 0;
  for (int seed = 0; seed < int(key.size()); ++seed) {
    if (key[seed] >= 0 || t.surface.label[seed] >= 0) continue;
    std::vector<int> found{seed};
    key[seed] = number;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (int g : t.beyond[found[i]])
        if (g >= 0 && key[g] < 0 && t.surface.label[g] < 0 && t.normal[g].dot(t.normal[found[i]]) > sharp)
          key[g] = number, found.push_back(g);
    ++number;
  }
  return key;
}

/// The labels, without those of openings.
std::vector<int> other_labels(const Surface<3>& surface, const Soup& soup) {
  std::vector<int> key = soup.face_id;
  for (std::size_t f = 0; f < key.size(); ++f)
    if (surface.label[f] >= 0) key[f] = -1;
  return key;
}

bool touches_an_opening(const SurfaceTopology& t, const Region& r) {
  return std::any_of(r.facets.begin(), r.facets.end(), [&](int f) {
    return std::any_of(t.beyond[f].begin(), t.beyond[f].end(),
                       [&](int g) { return g >= 0 && t.surface.label[g] >= 0; });
  });
}

bool looks_like_an_end(const SurfaceTopology& t, const Region& r, const std::vector<int>& key, double most) {
  double facets = 0;
  for (int f : r.facets) facets += area_vector(t.surface, f).norm();
  return r.facets.size() > 2 && r.area() > 0.5 * facets && r.unevenness < most * std::sqrt(r.area()) &&
         sharp_share(t, r, key) > 0.9 && !touches_an_opening(t, r);
}

/// The sides of a vessel of few sides look like ends too, but meet one another.
void drop_touching(const SurfaceTopology& t, std::vector<Region>& regions) {
  std::vector<int> owner(t.surface.facets.size(), -1);
  for (int r = 0; r < int(regions.size()); ++r)
    for (int f : regions[r].facets) owner[f] = r;
  std::vector<char> meets(regions.size(), 0);
  for (std::size_t f = 0; f < owner.size(); ++f)
    for (int g : t.beyond[f])
      if (owner[f] >= 0 && g >= 0 && owner[g] >= 0 && owner[g] != owner[f]) meets[owner[f]] = 1;
  std::vector<Region> kept;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (!meets[r]) kept.push_back(std::move(regions[r]));
  regions = std::move(kept);
}

/// `most`: unevenness over size.
std::vector<Region> candidates(const SurfaceTopology& t, const std::vector<int>& key, double most) {
  auto regions = parts(t, key);
  std::erase_if(regions, [&](const Region& r) { return !looks_like_an_end(t, r, key, most); });
  drop_touching(t, regions);
  drop_specks(regions, t.surface);
  return regions;
}

UnevenEnd described(const Region& r, const Soup& soup, const std::string& file, bool labelled) {
  UnevenEnd end{.centre = r.centre, .label = {}, .face_name = {}, .text = "end"};
  if (labelled) {
    const int id = soup.face_id[r.facets.front()];
    const auto name = soup.face_name.find(id);
    end.label = std::to_string(id);
    if (name != soup.face_name.end()) end.face_name = name->second;
    end.text = "face " + end.label + (end.face_name.empty() ? "" : " \"" + end.face_name + "\"");
  }
  const double across = std::sqrt(4 * r.area() / pi);
  end.text = fmt::format(
      "the {} of {} at {}, {} across, is not plane: it leaves its mean plane by {}, {:.2g} % of its width; "
      "{} is "
      "allowed{}",
      end.text, file, place(r.centre), size(across), size(r.unevenness), 100 * r.unevenness / across,
      size(allowed_unevenness(r.area(), labelled)), labelled ? "" : " for a face without label");
  return end;
}

}  // namespace

std::vector<UnevenEnd> uneven_ends(const Surface<3>& surface, const Soup& soup, const std::string& file) {
  const SurfaceTopology topology{surface, facet_normals(surface), neighbours(surface.facets)};
  std::vector<Region> regions;
  if (!soup.face_id.empty()) regions = candidates(topology, other_labels(surface, soup), 1.0);
  const bool labelled = !regions.empty();
  if (!labelled) regions = candidates(topology, between_sharp_edges(topology), 0.25);
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Region& a, const Region& b) { return a.area() > b.area(); });
  std::vector<UnevenEnd> ends;
  for (const auto& r : regions) ends.push_back(described(r, soup, file, labelled));
  return ends;
}

void refuse(const UnevenEnd& end, const std::string& where) {
  user_error("{}{}; cut the vessel by a plane there and close it with a flat face", where, end.text);
}

}  // namespace ostium::sph3d
