/// How much of a particle's kernel support lies in the wall, for a wall of any shape.
///
///   S(x) = int over the wall region of W(x - y) dy,      grad S(x) = int over the wall region of grad W(x -
///   y) dy
///
///   S is tabulated on a lattice of spacing dp/3 around the wall (blocks of 8^D nodes, only where needed) and
///   interpolated cubically, so that edges, apices and slivers of the input surface need no special
///   treatment: the pair (S, grad S) is a partition of unity with the fluid by construction. grad S points
///   into the wall.
///
///   symbol   meaning                                  unit
///   S        filling, 0 far from the wall             -
///   flux     grad S                                   1/m
///
/// The wall region is where the signed distance phi is positive. Built by convolving the cell fractions of
/// that region with W; the width of the fraction's ramp is removed by one step of inverse diffusion. Source:
/// docs/theory/walls.md, section "The filling of an arbitrary wall". Not checked: walls thinner than the
/// kernel (fluid on both sides) are seen as they are, each side by the other.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/vec.hpp"
#include "sph3d/fluid/wendland.hpp"

namespace ostium::sph3d {

template <int D>
struct WallSample {
  double filling = 0.0;
  Vec<D> flux = Vec<D>::Zero();
};

template <int D>
class WallField {
 public:
  /// phi(x) is called from several threads; lower and upper bound the fluid, dp is the particle spacing.
  WallField(const std::function<double(const Vec<D>&)>& phi, const Vec<D>& lower, const Vec<D>& upper,
            const Wendland<D>& kernel, double dp);

  WallSample<D> operator()(const Vec<D>& x) const;
  /// Whether the wall may be felt anywhere in a box; false is certain.
  bool felt_in(const Vec<D>& low, const Vec<D>& high) const;
  std::size_t bytes() const {
    return values_.size() * sizeof(float) + block_of_.size() * sizeof(std::int32_t) + felt_.size() * 8 +
           felt_slot_.size();
  }

 private:
  static constexpr int edge = 8;  // nodes per block and direction
  static constexpr int block_size = D == 2 ? edge * edge : edge * edge * edge;
  static constexpr int wide_row =
      edge + 4;                           // nodes -1 .. edge + 2 of a row: four in a row are never torn apart
  static constexpr float counts = 1e-6f;  // a filling below this is none
  static constexpr std::int32_t all_fluid = -1, all_wall = -2;  // blocks without nodes of their own
  using Index = std::array<int, D>;

  void find_blocks(const std::function<double(const Vec<D>&)>& phi, double reach);
  std::vector<float> fractions(const std::function<double(const Vec<D>&)>& phi) const;
  void convolve(const std::vector<float>& fraction, const Wendland<D>& kernel);
  void sharpen();
  void widen_rows();
  void find_felt();

  std::int32_t block_at(const Index& node) const;
  static int number_of(const Index& node);
  float node_value(const std::vector<float>& values, const Index& node) const;
  Index first_node(std::size_t block) const;
  Vec<D> position(const Index& node) const;

  double spacing_, nodes_per_length_ = 1.0 / spacing_;
  Vec<D> origin_;
  Index blocks_{};                       // blocks per direction
  std::vector<std::int32_t> block_of_;   // storage slot of a block, or all_fluid / all_wall
  std::vector<std::size_t> stored_;      // block number of a slot
  std::vector<float> values_;            // while building block by block, then in wide rows
  std::vector<std::uint64_t> felt_;      // of a slot: the cells with a filling, a bit each, eight words in 3D
  std::vector<std::uint8_t> felt_slot_;  // whether a slot has any such cell
};

extern template class WallField<2>;
extern template class WallField<3>;

}  // namespace ostium::sph3d
