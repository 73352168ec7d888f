/// Which points of a surface see which, and which see themselves and others in the mirror of a rim. Internal to shell/.
///
///   other   the point that is seen
///   rim     -1: where it is; k: its image in the mirror of rim k (there a point may see itself)
///
/// Points whose normals oppose each other lie across a lumen and do not see each other.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sph3d/shell/rim.hpp"

namespace ostium::sph3d {

struct SurfacePair {
  std::int32_t other, rim;
};

template <int D>
class SurfacePairs {
 public:
  SurfacePairs(const std::vector<Vec<D>>& position, const std::vector<Vec<D>>& normal,
               const std::vector<Rim<D>>& rims, double reach);

  std::span<const SurfacePair> of(std::size_t a) const {
    return {pairs_.data() + begin_[a], pairs_.data() + begin_[a + 1]};
  }

 private:
  std::vector<SurfacePair> pairs_;
  std::vector<std::size_t> begin_;
};

/// Where the other one is seen.
template <int D>
Vec<D> seen(const SurfacePair& pair, const std::vector<Vec<D>>& position, const std::vector<Rim<D>>& rims) {
  const Vec<D>& x = position[pair.other];
  return pair.rim < 0 ? x : rims[pair.rim].mirrored(x);
}

extern template class SurfacePairs<2>;
extern template class SurfacePairs<3>;

}  // namespace ostium::sph3d
