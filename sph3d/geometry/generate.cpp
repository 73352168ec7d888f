/// Bifurcation and arch: level sets of blended tubes, cut by planes.
#include "sph3d/geometry/generate.hpp"

#include <algorithm>
#include <numeric>

#include "core/error.hpp"
#include "sph3d/geometry/generate_checks.hpp"
#include "sph3d/geometry/level_set.hpp"

namespace ostium::sph3d {
namespace {

/// Vertices lie on the surface, chords inside it: this much more radius gives the polygon the area of the circle.
double with_chords(double radius, double edge) { return radius + edge * edge / (12 * radius); }

/// A tube that runs on straight for a while beyond its ends, where it will be cut.
struct Branch {
  TaperedTube tube;
  std::vector<End> ends;
};

void remove_unused_points(Surface<3>& s) {
  std::vector<int> number(s.points.size(), -1);
  std::vector<Vec3> points;
  for (auto& facet : s.facets)
    for (int& v : facet) {
      if (number[v] < 0) number[v] = int(points.size()), points.push_back(s.points[v]);
      v = number[v];
    }
  s.points = std::move(points);
}

/// Where the tubes can reach, ends included.
Bounds<3> box(const std::vector<Branch>& branches, double margin) {
  std::vector<Vec3> x;
  for (const auto& b : branches)
    for (const auto& p : b.tube.pieces) {
      const double r = std::max(b.tube.first, b.tube.last) + margin;
      std::vector<Vec3> on = {p.start, p.end};
      if (p.arc_radius > 0)
        on = {p.centre + Vec3::Constant(p.arc_radius), p.centre - Vec3::Constant(p.arc_radius)};
      for (const auto& c : on) x.push_back(c + Vec3::Constant(r)), x.push_back(c - Vec3::Constant(r));
    }
  return bounds(x);
}

Surface<3> build(const std::vector<Branch>& branches, double fillet, double edge) {
  std::vector<TaperedTube> tubes;
  for (const auto& b : branches) tubes.push_back(b.tube);
  auto surface = polygonise(blend(std::move(tubes), fillet), box(branches, fillet + 3 * edge), edge);
  int label = 0;
  for (const auto& b : branches)
    for (const auto& end : b.ends) cut(surface, end, label++, edge);
  remove_unused_points(surface);
  return surface;
}

/// A straight tube from `root` (inside another one) to `tip`, where it is cut.
Branch straight_branch(const Vec3& root, const Vec3& tip, double radius, double edge) {
  const Vec3 direction = (tip - root).normalized();
  const double r = with_chords(radius, edge), beyond = r + 4 * edge;
  return {{{line(root, tip + beyond * direction)}, r, r}, {{tip, direction, 2.2 * r + 5 * edge}}};
}

double edge_length(double wanted, double smallest_radius) {
  const double edge = wanted == 0 ? 0.25 * smallest_radius : wanted;
  check_positive("edge", edge);
  if (edge > 0.5 * smallest_radius)
    user_error("edge: at most half the smallest radius, {:.3g} m, found {:.3g} m", 0.5 * smallest_radius,
               edge);
  return edge;
}

void check_size(const Bounds<3>& box, double edge) {
  const double cells = (box.extent() / edge).prod();
  if (cells > 4e8)
    user_error("edge: {:.3g} m would need {:.2g} grid cells; choose a longer one", edge, cells);
}

}  // namespace

Surface<3> generate(const BifurcationShape& s) {
  const double second = s.second_daughter_radius == 0 ? s.daughter_radius : s.second_daughter_radius;
  for (auto [name, value] : {std::pair{"parent_radius", s.parent_radius},
                             {"parent_length", s.parent_length},
                             {"daughter_radius", s.daughter_radius},
                             {"second_daughter_radius", second},
                             {"daughter_length", s.daughter_length},
                             {"angle", s.angle},
                             {"fillet", s.fillet}})
    check_positive(name, value);
  const double widest = std::max({s.parent_radius, s.daughter_radius, second});
  if (s.angle < pi / 9 || s.angle > pi)
    user_error("angle: between 20 and 180 degrees, found {:.4g}", s.angle * 180 / pi);
  const double shortest = (widest + s.fillet) / std::sin(std::min(s.angle / 2, pi / 2));
  if (s.parent_length < 2 * widest || s.daughter_length < shortest + widest)
    user_error(
        "parent_length, daughter_length: at least {:.3g} m and {:.3g} m for these radii and this angle, "
        "found "
        "{:.3g} m and {:.3g} m",
        2 * widest, shortest + widest, s.parent_length, s.daughter_length);
  const double edge = edge_length(s.edge, std::min({s.parent_radius, s.daughter_radius, second}));
  const auto direction = [&](double sign) {
    return Vec3(sign * std::sin(s.angle / 2), 0, std::cos(s.angle / 2));
  };
  const std::vector<Branch> branches = {
      straight_branch(Vec3::Zero(), -s.parent_length * Vec3::UnitZ(), s.parent_radius, edge),
      straight_branch(Vec3::Zero(), s.daughter_length * direction(-1), s.daughter_radius, edge),
      straight_branch(Vec3::Zero(), s.daughter_length * direction(1), second, edge)};
  check_size(box(branches, s.fillet), edge);
  return build(branches, s.fillet, edge);
}

namespace {

void check(const ArchShape& s) {
  for (auto [name, value] : {std::pair{"ascending_radius", s.ascending_radius},
                             {"descending_radius", s.descending_radius},
                             {"arch_radius", s.arch_radius},
                             {"ascending_length", s.ascending_length},
                             {"descending_length", s.descending_length},
                             {"branch_length", s.branch_length},
                             {"fillet", s.fillet}})
    check_positive(name, value);
  for (double r : s.branch_radii) check_positive("branch_radii", r);
  const double widest = std::max(s.ascending_radius, s.descending_radius);
  if (s.arch_radius < 1.3 * widest)
    user_error("arch_radius: at least 1.3 times the widest radius, {:.3g} m, found {:.3g} m", 1.3 * widest,
               s.arch_radius);
}

/// The arch from the ascending end (x < 0) over the top (z > 0) to the descending end (x > 0).
Branch trunk(const ArchShape& s, double edge) {
  const Vec3 up = Vec3::UnitZ(), left = -s.arch_radius * Vec3::UnitX(), right = -left;
  const double first = with_chords(s.ascending_radius, edge), last = with_chords(s.descending_radius, edge);
  const double beyond = 0.3 * std::max(first, last) + 4 * edge;
  const Vec3 in = left - s.ascending_length * up, out = right - s.descending_length * up;
  // The taper runs over the extensions too: correct the radii so that they hold at the cuts.
  const double length = s.ascending_length + pi * s.arch_radius + s.descending_length;
  const double slope = (last - first) / length;
  const auto reach = [&](double r) { return std::hypot(1.2 * r, r + beyond) + 2 * edge; };
  return {{{line(in - beyond * up, left), arc(Vec3::Zero(), -Vec3::UnitX(), up, s.arch_radius, pi),
            line(right, out - beyond * up)},
           first - slope * beyond,
           last + slope * beyond},
          {{in, -up, reach(first)}, {out, -up, reach(last)}}};
}

/// Directions of the branches: fanned over the top of the arch, alternating a little to front and back.
std::vector<Branch> arch_branches(const ArchShape& s, double edge) {
  const double total = std::accumulate(s.branch_radii.begin(), s.branch_radii.end(), 0.0);
  const double widest = std::max(s.ascending_radius, s.descending_radius), outer = s.arch_radius + widest;
  constexpr double fan = 4 * pi / 9;  // 80 degrees of the half circle
  const int n = int(s.branch_radii.size());
  const double gap = (fan * outer - 2 * total) / std::max(n, 1);
  if (n > 0 && gap < s.fillet)
    user_error(
        "branch_radii: {} branches, together {:.3g} m wide, do not fit on {:.3g} m of the arch's outer wall "
        "with "
        "fillets of {:.3g} m; make fewer or thinner ones, or a larger arch_radius",
        n, 2 * total, fan * outer, s.fillet);
  std::vector<Branch> branches;
  double along = -0.5 * fan * outer + 0.5 * gap;
  for (int b = 0; b < n; ++b) {
    const double r = s.branch_radii[b];
    const double angle = (along + r) / outer, tilt = b % 2 ? -0.12 : 0.12;
    const Vec3 radial(std::sin(angle), 0, std::cos(angle));
    const Vec3 direction = (radial + tilt * Vec3::UnitY()).normalized();
    const Vec3 origin = s.arch_radius * radial;
    branches.push_back(straight_branch(origin + std::max(0.0, 0.5 * widest - r) * direction,
                                       origin + (widest + s.branch_length) * direction, r, edge));
    along += 2 * r + gap;
  }
  return branches;
}

}  // namespace

Surface<3> generate(const ArchShape& s) {
  check(s);
  double smallest = std::min(s.ascending_radius, s.descending_radius);
  for (double r : s.branch_radii) smallest = std::min(smallest, r);
  const double edge = edge_length(s.edge, smallest);
  std::vector<Branch> branches = {trunk(s, edge)};
  for (auto& b : arch_branches(s, edge)) branches.push_back(std::move(b));
  check_size(box(branches, s.fillet), edge);
  return build(branches, s.fillet, edge);
}

}  // namespace ostium::sph3d
