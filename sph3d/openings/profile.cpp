#include "sph3d/openings/profile.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/openings/flat_outline.hpp"

namespace ostium::sph3d {

namespace {

constexpr int cells_across = 64;

/// Developed flow on a square lattice: values at the nodes, 0 outside the outline.
struct DevelopedFlow {
  Vec2 origin;
  double spacing;
  int size;
  std::vector<double> values;
};

/// One leg of the five-point star: its length (cut at the outline) and the neighbour, -1 where it ends on the
/// outline.
struct Leg {
  double length;
  int neighbour;
};

DevelopedFlow solve(const Opening<3>& opening, const Eigen::Matrix<double, 3, 2>& frame) {
  const Surface<2> outline = flat_outline(opening, frame);
  const SignedDistance<2> distance(outline);
  Vec2 lower = outline.points.front(), upper = lower;
  for (const Vec2& p : outline.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  DevelopedFlow flow;
  flow.spacing = (upper - lower).maxCoeff() / cells_across;
  flow.origin = lower - Vec2::Constant(1.37 * flow.spacing);
  flow.size = cells_across + 4;
  const int n = flow.size;
  std::vector<double> phi(n * n);
  for (int k = 0; k < n * n; ++k) phi[k] = distance(flow.origin + flow.spacing * Vec2(k % n, k / n)).phi;

  std::vector<int> row(n * n, -1);
  int unknowns = 0;
  for (int k = 0; k < n * n; ++k)
    if (phi[k] < -1e-3 * flow.spacing) row[k] = unknowns++;
  const auto leg = [&](int k, int step) -> Leg {
    if (row[k + step] >= 0) return {flow.spacing, row[k + step]};
    const double inside = -phi[k], outside = std::max(phi[k + step], 0.0);
    return {flow.spacing * inside / (inside + outside), -1};
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < n * n; ++k) {
    if (row[k] < 0) continue;
    double diagonal = 0;
    for (const int axis : {1, n}) {
      const Leg a = leg(k, axis), b = leg(k, -axis);
      const double wa = 2.0 / (a.length * (a.length + b.length)),
                   wb = 2.0 / (b.length * (a.length + b.length));
      diagonal += wa + wb;
      if (a.neighbour >= 0) entries.emplace_back(row[k], a.neighbour, -wa);
      if (b.neighbour >= 0) entries.emplace_back(row[k], b.neighbour, -wb);
    }
    entries.emplace_back(row[k], row[k], diagonal);
  }
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd solution = solver.solve(Eigen::VectorXd::Ones(unknowns));

  flow.values.assign(n * n, 0.0);
  double sum = 0, area = 0;
  for (int k = 0; k < n * n; ++k) {
    if (row[k] >= 0) flow.values[k] = solution[row[k]];
    sum += flow.values[k];
    area += std::clamp(0.5 - phi[k] / flow.spacing, 0.0, 1.0);
  }
  for (double& value : flow.values) value *= area / sum;
  return flow;
}

}  // namespace

template <int D>
FlowShape<D>::FlowShape(Profile profile, const Opening<D>& opening)
    : profile_(profile), centre_(opening.centre), frame_(plane_frame(opening.normal)) {
  if constexpr (D == 2) {
    half_width_ = 0.5 * opening.area;
  } else if (profile == Profile::parabolic) {
    DevelopedFlow flow = solve(opening, frame_);
    origin_ = flow.origin;
    spacing_ = flow.spacing;
    size_ = flow.size;
    values_ = std::move(flow.values);
  }
}

template <int D>
double FlowShape<D>::operator()(const Vec<D>& x) const {
  if (profile_ == Profile::plug) return 1.0;
  const auto local = (frame_.transpose() * (x - centre_)).eval();
  if constexpr (D == 2) {
    const double y = local[0] / half_width_;
    return std::max(1.5 * (1.0 - y * y), 0.0);
  } else {
    const Vec2 u = (local - origin_) / spacing_;
    const int i = static_cast<int>(std::floor(u[0])), j = static_cast<int>(std::floor(u[1]));
    if (i < 0 || j < 0 || i + 1 >= size_ || j + 1 >= size_) return 0.0;
    const double a = u[0] - i, b = u[1] - j;
    const double* v = &values_[j * size_ + i];
    return (1 - b) * ((1 - a) * v[0] + a * v[1]) + b * ((1 - a) * v[size_] + a * v[size_ + 1]);
  }
}

template class FlowShape<2>;
template class FlowShape<3>;

}  // namespace ostium::sph3d
