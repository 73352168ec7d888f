/// One layer of particles across an opening, relaxed in its plane: the sites at which inflowing particles
/// appear.
///
///   sites     m   points in the plane of the opening, one particle each
///   spacing   m   distance of successive layers such that particles fill the duct exactly: V n = area *
///   spacing
///
/// The number of sites is round(area / dp^(D-1)). Source: docs/theory/openings.md, section "Slices".
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

template <int D>
struct Slice {
  std::vector<Vec<D>> sites;
  double spacing = 0;

  /// Indices of the sites around a point of the plane (within about two spacings; the nearest one at least).
  const std::vector<std::int32_t>& near(const Vec<D>& x) const;

  /// Sorts the sites into bins of this width (m) for `near`.
  void bin(double width);

 private:
  std::array<int, D> bin_of(const Vec<D>& x) const;
  double width_ = 1;
  Vec<D> lower_ = Vec<D>::Zero();
  std::array<int, D> bins_{};
  std::vector<std::vector<std::int32_t>> around_;  // of each bin: the sites in it and in the bins beside it
};

template <int D>
Slice<D> slice_of(const Opening<D>& opening, double dp);

template <>
Slice<2> slice_of<2>(const Opening<2>& opening, double dp);
template <>
Slice<3> slice_of<3>(const Opening<3>& opening, double dp);

}  // namespace ostium::sph3d
