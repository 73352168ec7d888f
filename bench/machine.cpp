#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <vector>

#include "bench/bench.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ostium::bench {

namespace {

constexpr int chains = 10;  // independent sums: two multiply-adds per cycle, each four or five cycles long

#if defined(__x86_64__)
__attribute__((target("avx2,fma"))) float multiply_add_avx2(long turns) {
  const __m256 a = _mm256_set1_ps(0.999f), b = _mm256_set1_ps(1e-3f);
  __m256 sum[chains];
  for (int k = 0; k < chains; ++k) sum[k] = _mm256_set1_ps(static_cast<float>(k));
  for (long n = 0; n < turns; ++n)
#pragma GCC unroll 10
    for (int k = 0; k < chains; ++k) sum[k] = _mm256_fmadd_ps(sum[k], a, b);
  for (int k = 1; k < chains; ++k) sum[0] = _mm256_add_ps(sum[0], sum[k]);
  return _mm256_cvtss_f32(sum[0]);
}
#endif

float multiply_add_four(long turns) {
  using Four = float __attribute__((vector_size(16)));
  Four sum[chains];
  for (int k = 0; k < chains; ++k) sum[k] = Four{} + static_cast<float>(k);
  for (long n = 0; n < turns; ++n)
#pragma GCC unroll 10
    for (int k = 0; k < chains; ++k) sum[k] = sum[k] * 0.999f + 1e-3f;
  for (int k = 1; k < chains; ++k) sum[0] += sum[k];
  return sum[0][0];
}

/// flop/s
double rate(float (*work)(long), int lanes) {
  constexpr long turns = 1000000;
  volatile float keep = 0;
  double best = 1e30;
  for (int round = 0; round < 5; ++round) best = std::min(best, seconds_of([&] { keep = work(turns); }));
  return 2.0 * chains * lanes * turns / best;
}

/// a = b + s c, two numbers read and one written.
double triad_rate() {
  constexpr std::size_t n = 8u << 20;
  std::vector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  double best = 1e30;
  for (int round = 0; round < 6; ++round) {
    best = std::min(best, seconds_of([&] {
                      for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 0.5 * c[i];
                    }));
    std::swap(a, b);
  }
  return 3.0 * sizeof(double) * n / best;
}

}  // namespace

MachineResult measure_machine() {
  MachineResult result{.multiply_add = rate(multiply_add_four, 4), .vectors = "4 lanes"};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    result.multiply_add = rate(multiply_add_avx2, 8), result.vectors = "AVX2";
#endif
  result.triad = triad_rate();
  result.cores = static_cast<int>(std::thread::hardware_concurrency());
  getloadavg(&result.load, 1);
  return result;
}

double peak_resident() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace ostium::bench
