#include "sph3d/walls/half_space.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

namespace {

constexpr int quadrature =
    160;  // midpoints per direction; the integrands vanish smoothly at the rim of the support

struct Sums {
  double filling = 0, moment_n = 0, moment_t = 0, friction_n = 0, friction_t = 0;
};

template <int D>
Sums integrate(const Wendland<D>& kernel, double s, double s_min, double most) {
  Sums sums;
  const double reach = kernel.reach(), dx = (reach - s) / quadrature;
  for (int i = 0; i < quadrature; ++i) {
    const double x = s + (i + 0.5) * dx;  // along the normal
    const double t_max = std::sqrt(std::max(reach * reach - x * x, 0.0)), dt = t_max / quadrature;
    const double lambda = 1.0 + std::min((x - s) / std::max(s, s_min), most);
    for (int j = 0; j < quadrature; ++j) {
      const double t = (j + 0.5) * dt;  // across it
      const double r = std::hypot(x, t), slope = -kernel.slope(r);
      const double dV = dx * dt * (D == 3 ? 2.0 * pi * t : 2.0);
      const double normal = x * x / (r * r), tangential = (1.0 - normal) / (D - 1);
      sums.filling += kernel.value(r) * dV;
      sums.moment_n += r * slope * normal * dV;
      sums.moment_t += r * slope * tangential * dV;
      sums.friction_n += 2.0 * lambda * slope / r * normal * dV;
      sums.friction_t += 2.0 * lambda * slope / r * tangential * dV;
    }
  }
  return sums;
}

template <int D>
double plane_integral(const Wendland<D>& kernel, double s) {
  const double t_max = std::sqrt(std::max(kernel.reach() * kernel.reach() - s * s, 0.0)),
               dt = t_max / (4 * quadrature);
  double sum = 0;
  for (int j = 0; j < 4 * quadrature; ++j) {
    const double t = (j + 0.5) * dt;
    sum += kernel.value(std::hypot(s, t)) * dt * (D == 3 ? 2.0 * pi * t : 2.0);
  }
  return sum;
}

}  // namespace

template <int D>
HalfSpace<D>::HalfSpace(const Wendland<D>& kernel, double dp, double most) : reach_(kernel.reach()) {
  for (int i = 0; i <= n; ++i) {
    const double s = reach_ * i / n;
    const Sums sums = integrate(kernel, s, 0.25 * dp, most);
    filling_[i] = sums.filling;
    flux_[i] = plane_integral(kernel, s);
    moment_n_[i] = sums.moment_n;
    moment_t_[i] = sums.moment_t;
    friction_n_[i] = sums.friction_n;
    friction_t_[i] = sums.friction_t;
  }
  const double whole = std::pow(0.5, 0.25), kink = std::pow(filling(0.25 * dp), 0.25);
  const double per_root = std::floor(shares * kink / whole) / kink;
  shares_per_root_ = static_cast<float>(per_root);
  for (int i = 0; i < shares + 2; ++i) {
    const double s = distance(std::min(std::pow(i / per_root, 4), 0.5));
    share_[i] = {float(moment_n(s)), float(moment_t(s)), float(friction_n(s)), float(friction_t(s))};
  }
}

template <int D>
double HalfSpace<D>::at(const Table& table, double s) const {
  const double x = std::clamp(s / reach_, 0.0, 1.0) * n;
  const int i = std::min(static_cast<int>(x), n - 1);
  return table[i] + (x - i) * (table[i + 1] - table[i]);
}

template <int D>
double HalfSpace<D>::filling(double s) const {
  return s >= 0.0 ? at(filling_, s) : 1.0 - at(filling_, -s);
}

template <int D>
double HalfSpace<D>::flux(double s) const {
  return at(flux_, std::abs(s));
}

template <int D>
double HalfSpace<D>::distance(double S) const {
  if (S <= 0.0) return reach_;
  if (S > 0.5) return -distance(1.0 - S);
  const auto below = std::partition_point(filling_.begin(), filling_.end(), [&](double f) { return f > S; });
  const auto i = std::max<std::ptrdiff_t>(below - filling_.begin(), 1);
  const double step = filling_[i - 1] - filling_[i];
  return reach_ / n * (i - 1 + (step > 0.0 ? std::min((filling_[i - 1] - S) / step, 1.0) : 0.0));
}

template <int D>
auto HalfSpace<D>::share(float S) const -> Share {
  const float x = std::sqrt(std::sqrt(std::clamp(S, 0.0f, 0.5f))) * shares_per_root_;
  const int i = static_cast<int>(x);
  const float t = x - static_cast<float>(i);
  const Share &a = share_[i], &b = share_[i + 1];
  const auto between = [t](float low, float high) { return low + t * (high - low); };
  return {between(a.moment_n, b.moment_n), between(a.moment_t, b.moment_t),
          between(a.friction_n, b.friction_n), between(a.friction_t, b.friction_t)};
}

template class HalfSpace<2>;
template class HalfSpace<3>;

}  // namespace ostium::sph3d
