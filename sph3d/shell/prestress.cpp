#include "sph3d/shell/prestress.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/shell/linear_shell.hpp"
#include "sph3d/shell/step.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
double dot(const ShellField<D>& a, const ShellField<D>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

template <int D>
void add(ShellField<D>& a, double s, const ShellField<D>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i].u += s * b[i].u, a[i].d += s * b[i].d;
}

template <int D>
bool is_nothing(const std::vector<ShellLoad<D>>& load) {
  const auto zero = [](double x) { return x == 0.0; };
  return std::all_of(load.begin(), load.end(), [&](const auto& block) {
    return std::all_of(&block.force[0][0], &block.force[0][0] + 8 * D, zero) &&
           std::all_of(block.pressure, block.pressure + 8, zero);
  });
}

/// Forces and moments of the load on the reference.
template <int D>
ShellField<D> forces(const ShellModel<D>& model, const std::vector<ShellLoad<D>>& load) {
  auto state = rest(model);
  ShellWorkspace<D> work(model);
  accelerate(model, state, load, work);
  ShellField<D> f(model.count());
  for (std::size_t a = 0; a < f.size(); ++a)
    for (int d = 0; d < D; ++d) {
      f[a].u[d] = work.force[a / 8].force[d][a % 8] * model.mass(a);
      f[a].d[d] = work.force[a / 8].moment[d][a % 8] * model.mass(a) * model.gyration2(a);
    }
  return f;
}

/// r over the size of K, particle by particle.
template <int D>
ShellField<D> scaled(const LinearShell<D>& shell, const ShellField<D>& r) {
  ShellField<D> z(r.size());
  for (std::size_t a = 0; a < r.size(); ++a) {
    const auto weight = shell.weight(a);
    z[a] = {r[a].u.cwiseQuotient(weight.u), r[a].d.cwiseQuotient(weight.d)};
  }
  return z;
}

/// What is still to come of the energy of x, over all of it: what the last fifth of the steps have brought
/// (after Hestenes & Stiefel 1952, section 6).
double missing(const std::vector<double>& gains) {
  const std::size_t last = std::max<std::size_t>(20, gains.size() / 5);
  if (gains.size() <= last) return 1.0;
  double all = 0.0, recent = 0.0;
  for (std::size_t k = 0; k < gains.size(); ++k) (k + last < gains.size() ? all : recent) += gains[k];
  return std::sqrt(recent / (all + recent));
}

[[noreturn]] void not_found(const PrestressReport& report) {
  numerics_error(
      "no stress in the wall was found that balances its pressure within {} iterations; what is missing is "
      "{:.3g} of the "
      "whole. Something has to hold the wall: clamp its ends or release them",
      report.iterations, report.error);
}

/// Conjugate gradients for K x = f.
template <int D>
ShellField<D> solve(const LinearShell<D>& shell, const ShellField<D>& f, const PrestressOptions& options,
                    const std::function<void(int, double)>& progress, PrestressReport& report) {
  ShellField<D> x(f.size()), r = f, z = scaled(shell, r), p = z;
  double rz = dot(r, z);
  const double least = 1e-28 * rz;
  std::vector<double> gains;
  for (; report.iterations < options.most_iterations; ++report.iterations) {
    const auto q = shell.stiffness(p);
    const double pKp = dot(p, q), step = rz / pKp;
    if (!(pKp > 0.0)) break;
    add(x, step, p);
    add(r, -step, q);
    gains.push_back(step * rz);
    z = scaled(shell, r);
    const double next = dot(r, z);
    for (std::size_t a = 0; a < p.size(); ++a) {
      p[a].u = z[a].u + next / rz * p[a].u;
      p[a].d = z[a].d + next / rz * p[a].d;
    }
    rz = next;
    if (report.iterations % 20 == 0 || rz < least) {
      report.error = rz < least ? 0.0 : missing(gains);
      if (progress) progress(report.iterations, report.error);
      if (report.error < options.tolerance) return x;
    }
  }
  not_found(report);
}

template <int D>
void check_size(const ShellModel<D>& model, const ShellField<D>& x, PrestressReport& report) {
  Vec<D> low = model.cloud.position[0], high = low;
  for (std::size_t a = 0; a < x.size(); ++a) {
    report.displacement = std::max(report.displacement, x[a].u.norm());
    low = low.cwiseMin(model.cloud.position[a]), high = high.cwiseMax(model.cloud.position[a]);
  }
  if (!(report.displacement < (high - low).norm())) not_found(report);
}

/// The force on the zigzag in the frame of n and the tangents.
template <int D>
Vec<D> in_own_frame(const ShellModel<D>& model, std::size_t a, const Vec<D>& force) {
  const auto& r = model.reference[a / 8];
  Eigen::Matrix<double, D, D> frame;
  for (int d = 0; d < D; ++d) {
    frame(d, 0) = r.N[d][a % 8];
    for (int t = 0; t + 1 < D; ++t) frame(d, 1 + t) = r.G[t][d][a % 8];
  }
  return frame.partialPivLu().solve(force);
}

template <int D>
void put(ShellPrestress<D>& block, std::size_t lane, const ShellMeasure<D>& s, const Vec<D>& zigzag) {
  constexpr int P = tangent_pairs<D>, T = tangents<D>;
  for (int k = 0; k < P; ++k) {
    block.traction[k][lane] = s.sheet.membrane.c[k];
    block.traction[P + k][lane] = s.sheet.bending.c[k];
    block.traction[2 * P + k][lane] = s.sheet.second.c[k];
  }
  for (int t = 0; t < T; ++t) block.traction[3 * P + t][lane] = s.sheet.shear[t];
  for (int d = 0; d < D; ++d) block.zigzag[d][lane] = zigzag[d];
}

template <int D>
ShellPrestressField<D> stress_of(const ShellModel<D>& model, const LinearShell<D>& shell,
                                 const ShellField<D>& x) {
  ShellPrestressField<D> out{std::vector<ShellPrestress<D>>(model.blocks(), ShellPrestress<D>{}), {}};
  for (std::size_t a = 0; a < x.size(); ++a) {
    const auto e = shell.strain(x, a), s = shell.stress(e, a);
    out.prestrain.push_back(e.sheet);
    put(out.blocks[a / 8], a % 8, s, in_own_frame(model, a, s.zigzag));
  }
  return out;
}

}  // namespace

template <int D>
std::vector<ShellLoad<D>> pressure_load(const ShellModel<D>& model, double pressure) {
  auto load = no_load(model);
  for (auto& block : load) std::fill_n(block.pressure, 8, pressure);
  return load;
}

template <int D>
PrestressReport find_prestress(ShellModel<D>& model, const std::vector<ShellLoad<D>>& load,
                               const PrestressOptions& options,
                               const std::function<void(int, double)>& progress) {
  PrestressReport report;
  model.prestress = {};
  if (is_nothing(load)) return report;
  const LinearShell<D> shell(model);
  const auto x = solve(shell, forces(model, load), options, progress, report);
  check_size(model, x, report);
  model.prestress = stress_of(model, shell, x);
  return report;
}

template std::vector<ShellLoad<2>> pressure_load(const ShellModel<2>&, double);
template std::vector<ShellLoad<3>> pressure_load(const ShellModel<3>&, double);
template PrestressReport find_prestress(ShellModel<2>&, const std::vector<ShellLoad<2>>&,
                                        const PrestressOptions&, const std::function<void(int, double)>&);
template PrestressReport find_prestress(ShellModel<3>&, const std::vector<ShellLoad<3>>&,
                                        const PrestressOptions&, const std::function<void(int, double)>&);

}  // namespace ostium::sph3d
