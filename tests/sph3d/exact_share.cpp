#include "exact_share.hpp"

#include <algorithm>

namespace ostium::sph3d {

template <int D>
ExactShare<D>::ExactShare(const Wendland<D>& kernel)
    : reach_(kernel.reach()), beyond_(n + 1), flux_beyond_(n + 1) {
  const double dr = reach_ / n;
  std::vector<double> W(n + 1), sum(n + 1);
  for (int i = 0; i <= n; ++i) {
    const double r = i * dr, top = std::sqrt(std::max(reach_ * reach_ - r * r, 0.0)), dz = top / 200;
    if constexpr (D == 2)
      W[i] = kernel.value(r);
    else
      for (int k = 0; k < 200; ++k) W[i] += 2 * dz * kernel.value(std::hypot(r, (k + 0.5) * dz));
  }
  for (int i = n - 1; i >= 0; --i) {
    const double r = i * dr;
    beyond_[i] = beyond_[i + 1] + 0.5 * dr * (W[i] * r + W[i + 1] * (r + dr));
    sum[i] = sum[i + 1] + 0.5 * dr * (W[i] + W[i + 1]);
  }
  for (int i = 0; i <= n; ++i) flux_beyond_[i] = i * dr * W[i] + sum[i];  // by parts
}

template <int D>
double ExactShare<D>::at(const std::vector<double>& table, double r) const {
  const double x = std::min(r / reach_, 1.0) * n;
  const int i = std::min(static_cast<int>(x), n - 1);
  return table[i] + (x - i) * (table[i + 1] - table[i]);
}

template <int D>
auto ExactShare<D>::tube(double R, double s) const -> Share {
  Share share{};
  for (int i = 0; i < rays; ++i) {
    const double c = std::cos(2 * pi * (i + 0.5) / rays), from_axis = R - s;
    const double l = -from_axis * c + std::sqrt(R * R - from_axis * from_axis * (1 - c * c));
    share.filling += 2 * pi / rays * at(beyond_, l);
    share.flux += 2 * pi / rays * c * at(flux_beyond_, l);
  }
  return share;
}

template <int D>
double ExactShare<D>::apex(const Vec2& x, double half_angle) const {
  const auto inside = [&](const Vec2& y) { return std::atan2(std::abs(y[1]), -y[0]) < half_angle; };
  double filling = 0;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2 * pi * (i + 0.5) / rays;
    const Vec2 d(std::cos(angle), std::sin(angle));
    std::vector<double> crossings{0.0, reach_};
    for (const int side : {-1, 1}) {
      const Vec2 along(-std::cos(half_angle), side * std::sin(half_angle));
      const double across = d[0] * along[1] - d[1] * along[0];
      const double l = -(x[0] * along[1] - x[1] * along[0]) / across;
      if (l > 0 && l < reach_ && (x + l * d).dot(along) > 0) crossings.push_back(l);
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k)
      if (inside(x + 0.5 * (crossings[k] + crossings[k + 1]) * d))
        filling += 2 * pi / rays * (at(beyond_, crossings[k]) - at(beyond_, crossings[k + 1]));
  }
  return filling;
}

template class ExactShare<2>;
template class ExactShare<3>;

}  // namespace ostium::sph3d
