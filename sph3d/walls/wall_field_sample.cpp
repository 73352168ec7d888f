// The look-up of the wall's filling: called for every particle near a wall in every advection step, so four nodes of a
// row at a time.
#include <cmath>
#include <experimental/simd>

#include "sph3d/walls/wall_field.hpp"

namespace ostium::sph3d {

namespace {

namespace stdx = std::experimental;
using Four = stdx::fixed_size_simd<float, 4>;

/// Weights of cubic Lagrange interpolation on nodes -1, 0, 1, 2 at t in [0, 1), and their derivatives.
struct Cubic {
  float w[4], d[4];
  explicit Cubic(float t) {
    constexpr float half = 1.0f / 2, sixth = 1.0f / 6;
    const float a = t + 1, b = t, c = t - 1, e = t - 2;
    w[0] = -sixth * b * c * e;
    w[1] = half * a * c * e;
    w[2] = -half * a * b * e;
    w[3] = sixth * a * b * c;
    d[0] = -sixth * (b * c + b * e + c * e);
    d[1] = half * (a * c + a * e + c * e);
    d[2] = -half * (a * b + a * e + b * e);
    d[3] = sixth * (a * b + a * c + b * c);
  }
};

Four four(const float* p) { return Four(p, stdx::element_aligned); }
float dot(const Four& a, const float* b) { return stdx::reduce(a * four(b)); }

/// At the edge of its reach an interpolated filling falls through zero at a slope: it is let fade, f (3 u^2 - 2 u^3) with
/// u = f / faint, so that nothing is pushed as it crosses that edge. The flux stays its gradient.
template <int D>
WallSample<D> faded(WallSample<D> sample) {
  constexpr double faint = 5e-4;
  const double u = sample.filling / faint;
  if (u >= 1.0) return sample;
  if (u <= 0.0) return {};
  sample.filling *= u * u * (3.0 - 2.0 * u);
  sample.flux *= u * u * (9.0 - 8.0 * u);
  return sample;
}

}  // namespace

template <int D>
WallSample<D> WallField<D>::operator()(const Vec<D>& x) const {
  static constexpr float nothing[4] = {}, everything[4] = {1, 1, 1, 1};
  Index node;
  float t[D];
  for (int d = 0; d < D; ++d) {
    const double u = std::max((x[d] - origin_[d]) * nodes_per_length_, -1.0);
    node[d] = static_cast<int>(u + 1.0) - 1;
    t[d] = static_cast<float>(u - node[d]);
  }
  WallSample<D> sample;
  const std::int32_t own = block_at(node);
  if (own < 0) {
    sample.filling = own == all_wall ? 1.0 : 0.0;
    return sample;
  }
  if (const int cell = number_of(node); !(felt_[own * (block_size / 64) + cell / 64] >> cell % 64 & 1))
    return sample;
  // the rows of the neighbourhood lie in up to two blocks per direction; a block all of fluid or wall is one row
  constexpr int layers = D == 3 ? 2 : 1;
  const int y = node[1] - 1, z = D == 3 ? node[D - 1] - 1 : 0, column = node[0] & (edge - 1);
  const float* first_row[2 * layers];
  std::ptrdiff_t step[2 * layers];
  for (int b = 0; b < 2 * layers; ++b) {
    Index at{node[0], y + edge * (b % 2)};
    if constexpr (D == 3) at[2] = z + edge * (b / 2);
    const std::int32_t slot = block_at(at);
    step[b] = slot < 0 ? 0 : wide_row;
    first_row[b] = slot >= 0
                       ? &values_[static_cast<std::size_t>(slot) * (block_size / edge) * wide_row + column]
                   : slot == all_wall ? everything
                                      : nothing;
  }
  int beside[4], number[4];  // of the four rows side by side: their block, and which row of it
  for (int j = 0; j < 4; ++j) {
    const int in_y = (y & (edge - 1)) + j;
    beside[j] = in_y / edge, number[j] = in_y & (edge - 1);
  }
  const auto row = [&](int j, int k) {  // four nodes from node[0] - 1
    const int in_z = (z & (edge - 1)) + k, block = 2 * (in_z / edge) + beside[j];
    return four(first_row[block] + ((in_z & (edge - 1)) * edge + number[j]) * step[block]);
  };
  const Cubic cx(t[0]), cy(t[1]);
  Four value = 0.0f, slope_y = 0.0f, slope_z = 0.0f;
  if constexpr (D == 3) {
    const Cubic cz(t[2]);
    for (int k = 0; k < 4; ++k) {
      Four plane = 0.0f, plane_y = 0.0f;
      for (int j = 0; j < 4; ++j) {
        const Four r = row(j, k);
        plane += cy.w[j] * r;
        plane_y += cy.d[j] * r;
      }
      value += cz.w[k] * plane;
      slope_y += cz.w[k] * plane_y;
      slope_z += cz.d[k] * plane;
    }
    sample.flux[2] = dot(slope_z, cx.w) * nodes_per_length_;
  } else {
    for (int j = 0; j < 4; ++j) {
      const Four r = row(j, 0);
      value += cy.w[j] * r;
      slope_y += cy.d[j] * r;
    }
  }
  sample.filling = dot(value, cx.w);
  sample.flux[0] = dot(value, cx.d) * nodes_per_length_;
  sample.flux[1] = dot(slope_y, cx.w) * nodes_per_length_;
  return faded(sample);
}

template WallSample<2> WallField<2>::operator()(const Vec<2>&) const;
template WallSample<3> WallField<3>::operator()(const Vec<3>&) const;

}  // namespace ostium::sph3d
