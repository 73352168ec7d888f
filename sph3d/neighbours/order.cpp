#include "sph3d/neighbours/order.hpp"

#include <algorithm>
#include <numeric>

namespace ostium::sph3d {

namespace {

template <int D>
struct Entry {
  float x[D];
  std::int32_t index;
};

template <int D>
int longest_side(const Entry<D>* begin, const Entry<D>* end) {
  int longest = 0;
  float length = -1;
  for (int d = 0; d < D; ++d) {
    float low = begin->x[d], high = low;
    for (const Entry<D>* e = begin; e != end; ++e)
      low = std::min(low, e->x[d]), high = std::max(high, e->x[d]);
    if (high - low > length) longest = d, length = high - low;
  }
  return longest;
}

template <int D>
void bisect(Entry<D>* begin, Entry<D>* end) {
  const std::ptrdiff_t n = end - begin;
  if (n <= 8) return;
  const std::ptrdiff_t half = std::max<std::ptrdiff_t>((n / 2 + 4) / 8 * 8, 8);  // whole clusters on the left
  const int d = longest_side(begin, end);
  std::nth_element(begin, begin + half, end, [d](const Entry<D>& a, const Entry<D>& b) {
    return a.x[d] < b.x[d] || (a.x[d] == b.x[d] && a.index < b.index);
  });
#pragma omp task if (n > 4096)
  bisect(begin, begin + half);
  bisect(begin + half, end);
}

}  // namespace

template <int D>
std::vector<std::int32_t> bisection_order(const std::vector<Vec<D>>& positions) {
  std::vector<Entry<D>> entries(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec<D> x = positions[i] - positions[0];
    for (int d = 0; d < D; ++d) entries[i].x[d] = static_cast<float>(x[d]);
    entries[i].index = static_cast<std::int32_t>(i);
  }
#pragma omp parallel
#pragma omp single
  bisect(entries.data(), entries.data() + entries.size());
  std::vector<std::int32_t> order(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = entries[i].index;
  return order;
}

template std::vector<std::int32_t> bisection_order<2>(const std::vector<Vec<2>>&);
template std::vector<std::int32_t> bisection_order<3>(const std::vector<Vec<3>>&);

}  // namespace ostium::sph3d
