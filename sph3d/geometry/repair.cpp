#include "sph3d/geometry/repair.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace ostium::sph3d {
namespace {

/// Whether the two triangles of an edge run along it in the same sense, which neighbours must not.
bool disagree(const Soup& soup, std::span<const EdgeUse> uses) {
  return forward(soup.facets, uses[0]) == forward(soup.facets, uses[1]);
}

struct Link {
  int facet;
  bool turned;  ///< relative to each other as stored
};

std::vector<std::array<Link, 3>> links(const Soup& soup) {
  std::vector<std::array<Link, 3>> link(soup.facets.size(), {Link{-1, false}, {-1, false}, {-1, false}});
  for_each_edge(edge_uses(soup.facets), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const bool turned = disagree(soup, uses);
    link[uses[0].facet][uses[0].slot] = {uses[1].facet, turned};
    link[uses[1].facet][uses[1].slot] = {uses[0].facet, turned};
  });
  return link;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Marks the facets of one shell that must be turned to agree with its first one; returns the shell.
std::vector<int> follow(const Soup& soup, const std::vector<std::array<Link, 3>>& link, int start,
                        std::vector<signed char>& sense) {
  std::vector<int> shell{start};
  sense[start] = 1;
  for (std::size_t i = 0; i < shell.size(); ++i)
    for (const auto& [g, turned] : link[shell[i]]) {
      if (g < 0) continue;
      const signed char wanted = turned ? -sense[shell[i]] : sense[shell[i]];
      if (sense[g] == 0)
        sense[g] = wanted, shell.push_back(g);
      else if (sense[g] != wanted)
        user_error("the surface has no inside: it turns over on itself like a Moebius band near {}",
                   place(soup.points[soup.facets[g][0]]));
    }
  return shell;
}

std::vector<double> shell_volumes(const Soup& soup, const std::vector<int>& shell, int count) {
  std::vector<double> volume(count, 0.0);
  const Vec3 origin = soup.points[soup.facets[0][0]];
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    const auto [a, b, c] = soup.facets[f];
    const Vec3 x = soup.points[a] - origin, y = soup.points[b] - origin, z = soup.points[c] - origin;
    volume[shell[f]] += x.dot(y.cross(z)) / 6;
  }
  return volume;
}

std::string list_shells(const Soup& soup, const std::vector<int>& shell, const std::vector<double>& volume) {
  std::string text;
  for (std::size_t s = 0; s < volume.size() && s < 8; ++s) {
    const auto f = std::find(shell.begin(), shell.end(), int(s)) - shell.begin();
    text += fmt::format("{}{:.4g} mL near {}", s ? "; " : "", std::abs(volume[s]) * 1e6,
                        place(soup.points[soup.facets[f][0]]));
  }
  return text;
}

}  // namespace

std::string place(const Vec3& x) {
  const auto mm = [](double metres) { return std::abs(metres) < 1e-9 ? 0.0 : 1e3 * metres; };
  return fmt::format("({:.5g}, {:.5g}, {:.5g}) mm", mm(x.x()), mm(x.y()), mm(x.z()));
}

std::string size(double length) { return fmt::format("{:.3g} mm", 1e3 * length); }

void check_manifold(const Soup& soup) {
  int count = 0;
  std::string first;
  for_each_edge(edge_uses(soup.facets), [&](std::span<const EdgeUse> uses) {
    if (uses.size() <= 2) return;
    const Vec3 middle = 0.5 * (soup.points[uses[0].lower] + soup.points[uses[0].upper]);
    if (count++ == 0) first = fmt::format("{} at {}", uses.size(), place(middle));
  });
  if (count > 0)
    user_error(
        "{} edges are shared by more than two triangles (the first by {}); a vessel surface has two at every "
        "edge: remove inner walls and overlapping parts",
        count, first);
}

void orient_consistently(Soup& soup) {
  const auto link = links(soup);
  std::vector<signed char> sense(soup.facets.size(), 0);
  int turned = 0;
  for (int start = 0; start < int(soup.facets.size()); ++start) {
    if (sense[start] != 0) continue;
    auto shell = follow(soup, link, start, sense);
    const auto minority = std::count_if(shell.begin(), shell.end(), [&](int f) { return sense[f] < 0; });
    const signed char turn_which = 2 * minority > std::ssize(shell) ? 1 : -1;
    for (int f : shell)
      if (sense[f] == turn_which) turn(soup.facets[f]), ++turned;
  }
  if (turned > 0)
    soup.notes.push_back(fmt::format("{} triangles ran against their neighbours and were turned", turned));
}

std::vector<int> shells(const Soup& soup) {
  const auto beyond = neighbours(soup.facets);
  std::vector<int> shell(soup.facets.size(), -1), open;
  int count = 0;
  for (int start = 0; start < int(shell.size()); ++start) {
    if (shell[start] >= 0) continue;
    shell[start] = count, open.push_back(start);
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      for (int g : beyond[f])
        if (g >= 0 && shell[g] < 0) shell[g] = count, open.push_back(g);
    }
    ++count;
  }
  return shell;
}

void settle_shells(Soup& soup) {
  const auto shell = shells(soup);
  const int count = 1 + *std::max_element(shell.begin(), shell.end());
  auto volume = shell_volumes(soup, shell, count);
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(volume.begin(), volume.end(), larger) - volume.begin();
  if (!(std::abs(volume[largest]) > 0)) user_error("the surface encloses no volume");
  constexpr double leftover = 1e-3;  // of the largest shell's volume
  for (int s = 0; s < count; ++s)
    if (s != largest && std::abs(volume[s]) > leftover * std::abs(volume[largest]))
      user_error("the surface has {} separate shells ({}); keep the one that is the vessel", count,
                 list_shells(soup, shell, volume));
  if (volume[largest] < 0) {
    for (auto& facet : soup.facets) turn(facet);
    soup.notes.push_back("all normals pointed inward and were turned");
  }
  if (count == 1) return;
  std::vector<char> keep(soup.facets.size());
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = shell[f] == largest;
  keep_facets(soup, keep);
  drop_unused_points(soup);
  soup.notes.push_back(fmt::format("{} leftover shells without noteworthy volume dropped", count - 1));
}

}  // namespace ostium::sph3d
