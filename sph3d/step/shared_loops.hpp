/// Loops over clusters that all threads share.
///
/// Each thread begins with a stretch of its own, the same one in every loop, so that its core finds its data at hand; who has
/// finished helps the others. A thread that the system held up for a moment, or whose clusters are all near walls, then
/// does not keep everybody waiting. What a part computes does not depend on who does it: a part writes to its own
/// clusters alone.
#pragma once
#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace ostium::sph3d {

/// f(part) for part = 0 .. parts - 1. A part should take some microseconds at least.
template <class F>
void for_parts(std::size_t parts, F&& f) {
  struct alignas(64) Stretch {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };
  const std::size_t threads = omp_get_max_threads();
  std::vector<Stretch> stretches(threads);
  for (std::size_t t = 0; t < threads; ++t) {
    stretches[t].next = parts * t / threads;
    stretches[t].end = parts * (t + 1) / threads;
  }
#pragma omp parallel
  for (std::size_t t = 0, me = omp_get_thread_num(); t < threads; ++t) {
    Stretch& stretch = stretches[(me + t) % threads];
    for (std::size_t part; (part = stretch.next.fetch_add(1, std::memory_order_relaxed)) < stretch.end;)
      f(part);
  }
}

constexpr std::size_t batch = 16;  // clusters, 128 particles

/// f(begin, end) over batches of clusters.
template <class F>
void for_batches(std::size_t clusters, F&& f) {
  for_parts((clusters + batch - 1) / batch,
            [&](std::size_t part) { f(part * batch, std::min((part + 1) * batch, clusters)); });
}

/// f(cluster) for every cluster.
template <class F>
void for_clusters(std::size_t clusters, F&& f) {
  for_batches(clusters, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) f(c);
  });
}

}  // namespace ostium::sph3d
