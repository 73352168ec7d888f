#include "sph3d/walls/shell_body.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/shell/recover.hpp"

namespace ostium::sph3d {

namespace {

/// What the tissue around the wall allows: its springs' period and its dashpots' decay.
template <int D>
double longest_step_of_support(const ShellModel<D>& model) {
  const ShellOptions& o = model.options;
  double longest = 1e300;
  for (const double t : model.cloud.thickness) {
    const double mass = o.density * t;
    if (o.spring > 0) longest = std::min(longest, 2.0 * std::sqrt(mass / o.spring));
    if (o.dashpot > 0) longest = std::min(longest, mass / o.dashpot);
  }
  return o.cfl * longest;
}

double length_or_area(const ShellPoint<2>& p, double depth) { return (p.x[0] - depth * p.dn[0]).norm(); }
double length_or_area(const ShellPoint<3>& p, double depth) {
  return (p.x[0] - depth * p.dn[0]).cross(p.x[1] - depth * p.dn[1]).norm();
}

}  // namespace

template <int D>
ShellBody<D>::ShellBody(ShellModel<D> model, std::vector<Vec<D>> contact)
    : model_(std::move(model)),
      contact_(std::move(contact)),
      longest_step_(std::min(stable_step(model_), longest_step_of_support(model_))),
      work_(model_),
      load_(no_load(model_)) {
  const ShellCloud<D>& cloud = model_.cloud;
  OSTIUM_ASSERT(contact_.size() == cloud.count(), "{} contact points, {} shell particles", contact_.size(),
                cloud.count());
  for (std::size_t a = 0; a < contact_.size(); ++a)
    depth_.push_back((cloud.position[a] - contact_[a]).dot(cloud.normal[a]));
}

template <int D>
std::vector<Vec<D>> ShellBody<D>::normals(const ShellState<D>& shell) const {
  std::vector<Vec<D>> n(count());
  for (std::size_t a = 0; a < n.size(); ++a) n[a] = shell.normal(a);
  return n;
}

template <int D>
std::vector<Vec<D>> ShellBody<D>::contacts(const ShellState<D>& shell) const {
  std::vector<Vec<D>> x(count());
  for (std::size_t a = 0; a < x.size(); ++a)
    x[a] = model_.cloud.position[a] + shell.displacement(a) - depth_[a] * shell.normal(a);
  return x;
}

template <int D>
std::vector<WallPoint<D>> ShellBody<D>::points(const ShellState<D>& shell) const {
  const auto contact = contacts(shell);
  std::vector<WallPoint<D>> points(contact.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < points.size(); ++a) {
    const Vec<D> n = shell.normal(a), middle = model_.cloud.position[a] + shell.displacement(a);
    const double stretch = length_or_area(ShellPoint<D>(model_, shell, a), (middle - contact[a]).dot(n));
    points[a] = {contact[a], n, stretch * model_.cloud.area[a]};
  }
  return points;
}

template <int D>
void ShellBody<D>::step(ShellState<D>& shell, double dt, const std::vector<Vec<D>>& force, double pressure) {
  for (std::size_t a = 0; a < count(); ++a) {
    for (int d = 0; d < D; ++d) load_[a / 8].force[d][a % 8] = force[a][d];
    load_[a / 8].pressure[a % 8] = pressure;
  }
  const double stable = std::min(longest_step_, stable_step(model_, shell, work_));
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / stable)));
  advance(model_, shell, load_, work_, {.dt = dt / steps, .count = steps});
}

template class ShellBody<2>;
template class ShellBody<3>;

}  // namespace ostium::sph3d
