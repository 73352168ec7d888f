/// The order of the particles in memory: nested bisection of the cloud along its longest side.
///
/// Every eight consecutive entries are close together, and so are every 16, 32, ...; a cluster of eight then
/// shares most of its neighbours, and neighbouring clusters most of their cache lines. Source:
/// docs/theory/engine.md, section "Order". Costs about 0.2 us per particle; worth repeating every 10-20
/// steps.
#pragma once
#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

/// A permutation of 0..positions.size()-1; the same for the same input, whatever the number of threads.
template <int D>
std::vector<std::int32_t> bisection_order(const std::vector<Vec<D>>& positions);

extern template std::vector<std::int32_t> bisection_order<2>(const std::vector<Vec<2>>&);
extern template std::vector<std::int32_t> bisection_order<3>(const std::vector<Vec<3>>&);

}  // namespace ostium::sph3d
