/// Surface nets (Gibson 1998): one vertex per cell that the level set crosses, one quad per crossed grid edge.
#include <algorithm>
#include <cmath>

#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/level_set.hpp"

namespace ostium::sph3d {
namespace {

struct Lattice {
  Vec3 lower;
  double cell;
  std::array<int, 3> n;  ///< nodes per direction
  int at(int i, int j, int k) const { return i + n[0] * (j + n[1] * k); }
  int step(int axis) const { return axis == 0 ? 1 : axis == 1 ? n[0] : n[0] * n[1]; }
  Vec3 node(int i, int j, int k) const { return lower + cell * Vec3(i, j, k); }
};

Lattice lattice(const Bounds<3>& box, double cell) {
  Lattice l{box.lower, cell, {}};
  for (int d = 0; d < 3; ++d) l.n[d] = 2 + int(std::ceil(box.extent()[d] / cell));
  return l;
}

/// f is a distance, or less: far from the surface one value tells the sign of the next nodes too.
int nodes_told(double f, double cell) { return std::max(0, int(0.8 * std::abs(f) / cell) - 2); }

std::vector<float> sample(const LevelSet& f, const Lattice& l) {
  std::vector<float> value(std::size_t(l.n[0]) * l.n[1] * l.n[2]);
#pragma omp parallel for schedule(dynamic, 4)
  for (int k = 0; k < l.n[2]; ++k)
    for (int j = 0; j < l.n[1]; ++j)
      for (int i = 0, told = 0; i < l.n[0]; ++i) {
        if (told-- > 0) {
          value[l.at(i, j, k)] = value[l.at(i - 1, j, k)];
          continue;
        }
        const double here = f(l.node(i, j, k));
        value[l.at(i, j, k)] = float(here);
        told = nodes_told(here, l.cell);
      }
  return value;
}

/// Calls visit(node) for every node that has a neighbour ahead in all three directions.
template <class Visit>
void for_each_cell(const Lattice& l, Visit visit) {
  for (int k = 0; k + 1 < l.n[2]; ++k)
    for (int j = 0; j + 1 < l.n[1]; ++j)
      for (int i = 0; i + 1 < l.n[0]; ++i) visit(i, j, k);
}

void flip_nearest(std::vector<float>& value, std::span<const int> nodes) {
  const int at = *std::min_element(nodes.begin(), nodes.end(),
                                   [&](int a, int b) { return std::abs(value[a]) < std::abs(value[b]); });
  value[at] = value[at] < 0 ? 1e-30f : -1e-30f;
}

/// A strip thinner than a cell, where a wall just touches a plane of the grid, crosses faces of cells at both
/// diagonals: the net would pinch there. Such nodes change side; the vertices find the true surface later.
void unpinch(std::vector<float>& value, const Lattice& l) {
  const auto inside = [&](int at) { return value[at] < 0; };
  bool again = true;
  for (int pass = 0; again && pass < 50; ++pass) {
    again = false;
    for_each_cell(l, [&](int i, int j, int k) {
      const int at = l.at(i, j, k), all = at + l.step(0) + l.step(1) + l.step(2);
      for (int axis = 0; axis < 3; ++axis) {
        const int u = l.step((axis + 1) % 3), v = l.step((axis + 2) % 3);
        const std::array face = {at, at + u, at + u + v, at + v};
        if (inside(face[0]) != inside(face[2]) || inside(face[1]) != inside(face[3]) ||
            inside(face[0]) == inside(face[1]))
          continue;
        flip_nearest(value, face), again = true;
      }
      // Two opposite corners of the cell, alone on their side.
      const std::array across = {at, all};
      bool alone = inside(at) == inside(all);
      for (int d = 0; d < 3 && alone; ++d)
        alone = inside(at + l.step(d)) != inside(at) && inside(all - l.step(d)) != inside(at);
      if (alone) flip_nearest(value, across), again = true;
    });
  }
}

/// Mean of the crossings on the edges of the cell whose lowest node is `at`; false if there is none.
bool mean_crossing(const std::vector<float>& value, const Lattice& l, int at, Vec3& mean) {
  int count = 0;
  mean.setZero();
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      if (corner >> axis & 1) continue;
      int a = at;
      for (int d = 0; d < 3; ++d) a += (corner >> d & 1) * l.step(d);
      const float fa = value[a], fb = value[a + l.step(axis)];
      if ((fa < 0) == (fb < 0)) continue;
      Vec3 x(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      x[axis] += fa / (fa - fb);
      mean += x;
      ++count;
    }
  if (count > 0) mean /= count;
  return count > 0;
}

/// The quad around the grid edge from node `at` along `axis`, split along its shorter diagonal.
void add_quad(Surface<3>& s, const std::vector<int>& vertex, const Lattice& l, int at, int axis,
              bool leaving) {
  const int u = l.step((axis + 1) % 3), v = l.step((axis + 2) % 3);
  std::array<int, 4> q = {vertex[at - u - v], vertex[at - v], vertex[at], vertex[at - u]};
  if (!leaving) std::swap(q[1], q[3]);
  const auto& x = s.points;
  const bool first = (x[q[0]] - x[q[2]]).norm() < (x[q[1]] - x[q[3]]).norm();
  if (first)
    s.facets.push_back({q[0], q[1], q[2]}), s.facets.push_back({q[0], q[2], q[3]});
  else
    s.facets.push_back({q[0], q[1], q[3]}), s.facets.push_back({q[1], q[2], q[3]});
}

Surface<3> nets(const std::vector<float>& value, const Lattice& l) {
  Surface<3> s;
  std::vector<int> vertex(value.size(), -1);
  for_each_cell(l, [&](int i, int j, int k) {
    Vec3 x;
    if (!mean_crossing(value, l, l.at(i, j, k), x)) return;
    vertex[l.at(i, j, k)] = int(s.points.size());
    s.points.push_back(l.node(i, j, k) + l.cell * x);
  });
  for (int k = 1; k + 1 < l.n[2]; ++k)
    for (int j = 1; j + 1 < l.n[1]; ++j)
      for (int i = 1; i + 1 < l.n[0]; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          const int at = l.at(i, j, k);
          const bool inside = value[at] < 0, beyond = value[at + l.step(axis)] < 0;
          if (inside != beyond) add_quad(s, vertex, l, at, axis, inside);
        }
  s.label.assign(s.facets.size(), -1);
  return s;
}

Vec3 gradient(const LevelSet& f, const Vec3& x, double h) {
  Vec3 g;
  for (int d = 0; d < 3; ++d) g[d] = (f(x + h * Vec3::Unit(d)) - f(x - h * Vec3::Unit(d))) / (2 * h);
  return g;
}

Vec3 onto(const LevelSet& f, Vec3 x, double cell, int steps) {
  for (int step = 0; step < steps; ++step) {
    const Vec3 g = gradient(f, x, 1e-3 * cell);
    x -= f(x) / std::max(g.squaredNorm(), 0.25) * g;
  }
  return x;
}

/// Moves every vertex half way to the mean of its neighbours, then back onto the level set.
void even_out(Surface<3>& s, const LevelSet& f, double cell, int newton_steps) {
  std::vector<Vec3> sum(s.points.size(), Vec3::Zero());
  std::vector<int> count(s.points.size(), 0);
  for (const auto& t : s.facets)
    for (int k = 0; k < 3; ++k) sum[t[k]] += s.points[t[(k + 1) % 3]], ++count[t[k]];
#pragma omp parallel for
  for (int i = 0; i < int(s.points.size()); ++i)
    s.points[i] = onto(f, 0.5 * (s.points[i] + sum[i] / std::max(count[i], 1)), cell, newton_steps);
}

}  // namespace

Surface<3> polygonise(const LevelSet& f, const Bounds<3>& box, double cell) {
  const auto l = lattice(box, cell);
  auto value = sample(f, l);
  unpinch(value, l);
  auto surface = nets(value, l);
  for (int pass = 0; pass < 6; ++pass) even_out(surface, f, cell, pass < 5 ? 1 : 3);
  return surface;
}

}  // namespace ostium::sph3d
