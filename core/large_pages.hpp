/// Long arrays that are streamed again and again, in large pages where the system has them: fewer address translations.
///
/// The request is made before the memory is touched. Where it cannot be met nothing changes but the time taken.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace ostium {

/// What of these bytes fills large pages of 2 MiB shall be in such.
inline void ask_for_large_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t page = 4096, large = 512 * page;
  if (bytes < 2 * large) return;
  const auto first = (reinterpret_cast<std::uintptr_t>(data) + page - 1) / page * page;
  const auto last = (reinterpret_cast<std::uintptr_t>(data) + bytes) / page * page;
  madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

/// Gives a vector n elements and a little room to grow; where it must move for that, into large pages.
template <class T>
void resize_in_large_pages(std::vector<T>& vector, std::size_t n) {
  if (n + n / 64 > vector.capacity()) {
    vector.reserve(n + n / 32);
    ask_for_large_pages(vector.data(), vector.capacity() * sizeof(T));
  }
  vector.resize(n);
}

/// Gives a vector that came from elsewhere, and may stand in small pages, memory of that kind.
template <class T>
void move_to_large_pages(std::vector<T>& vector) {
  std::vector<T> moved;
  resize_in_large_pages(moved, vector.size());
  std::copy(vector.begin(), vector.end(), moved.begin());
  vector = std::move(moved);
}

}  // namespace ostium
