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
    const float a = t + 1, b = t, c = t - 1, e = t - 2;
    w[0] = -b * c * e / 6;
    w[1] = a * c * e / 2;
    w[2] = -a * b * e / 2;
    w[3] = a * b * c / 6;
    d[0] = -(b * c + b * e + c * e) / 6;
    d[1] = (a * c + a * e + c * e) / 2;
    d[2] = -(a * b + a * e + b * e) / 2;
    d[3] = (a * b + a * c + b * c) / 6;
  }
};

Four four(const float* p) { return Four(p, stdx::element_aligned); }
float dot(const Four& a, const float* b) { return stdx::reduce(a * four(b)); }

}  // namespace

template <int D>
WallSample<D> WallField<D>::operator()(const Vec<D>& x) const {
  static constexpr float nothing[4] = {}, everything[4] = {1, 1, 1, 1};
  Index node;
  float t[D];
  for (int d = 0; d < D; ++d) {
    const double u = std::max((x[d] - origin_[d]) / spacing_, -1.0);
    node[d] = static_cast<int>(u + 1.0) - 1;
    t[d] = static_cast<float>(u - node[d]);
  }
  WallSample<D> sample;
  if (const std::int32_t slot = block_at(node); slot < 0) {
    sample.filling = slot == all_wall ? 1.0 : 0.0;
    return sample;
  }
  // the rows of the neighbourhood lie in up to two blocks per direction
  constexpr int layers = D == 3 ? 2 : 1;
  const int y = node[1] - 1, z = D == 3 ? node[D - 1] - 1 : 0, column = node[0] & (edge - 1);
  const float *corner[layers][2],
      *uniform[layers][2];  // first row of a block, or none where the block is all fluid or all wall
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < 2; ++j) {
      Index at{node[0], y + edge * j};
      if constexpr (D == 3) at[2] = z + edge * k;
      const std::int32_t slot = block_at(at);
      corner[k][j] = slot < 0
                         ? nullptr
                         : &values_[static_cast<std::size_t>(slot) * (block_size / edge) * wide_row + column];
      uniform[k][j] = slot == all_wall ? everything : nothing;
    }
  const auto row = [&](int j, int k) {  // four nodes from node[0] - 1
    const int second_y = (y + j) / edge != y / edge, second_z = (z + k) / edge != z / edge;
    const float* block = corner[second_z][second_y];
    const int r = ((z + k) & (edge - 1)) * edge + ((y + j) & (edge - 1));
    return four(block ? block + r * wide_row : uniform[second_z][second_y]);
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
    sample.flux[2] = dot(slope_z, cx.w) / spacing_;
  } else {
    for (int j = 0; j < 4; ++j) {
      const Four r = row(j, 0);
      value += cy.w[j] * r;
      slope_y += cy.d[j] * r;
    }
  }
  sample.filling = dot(value, cx.w);
  sample.flux[0] = dot(value, cx.d) / spacing_;
  sample.flux[1] = dot(slope_y, cx.w) / spacing_;
  if (sample.filling < 1e-6) return {};
  return sample;
}

template WallSample<2> WallField<2>::operator()(const Vec<2>&) const;
template WallSample<3> WallField<3>::operator()(const Vec<3>&) const;

}  // namespace ostium::sph3d
