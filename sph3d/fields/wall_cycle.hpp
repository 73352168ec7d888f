/// What the wall has felt in a cycle: time-averaged wall shear stress, how much it oscillates, mean pressure.
///
///   TAWSS = (1/T) int |tau| dt,   OSI = (1 - |int tau dt| / int |tau| dt) / 2,   RRT = 1 / ((1 - 2 OSI) TAWSS)
///   theta dtau/dt = tau_sampled - tau,   theta = T / (2 pi 20)
///
///   symbol   meaning                                                                              unit
///   tau      wall shear stress in the frame of the material: turned back to where the wall was at rest       Pa
///   T        duration of the cycle                                                                s
///   theta    of the filter at twenty times the frequency of the cycle: noise would raise |tau| and OSI; the first harmonic
///            loses 0.13 %, the fifth 3 %
///   RRT      relative residence time, T / |int tau dt|                                            1/Pa
///
/// Trapezoids over the samples; one that lies across the end of a cycle is shared by both cycles. Plain data, so that a
/// checkpoint holds it. Source: He & Ku 1996 (OSI); Himburg et al. 2004 (RRT); docs/theory/walls.md, "Wall fields". Not
/// checked: that the samples are dense enough.
#pragma once
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
struct WallCycle {
  std::int64_t number = 0;            ///< of the running cycle, from 0
  double time = 0;                    ///< of the last sample, s
  double duration = 0;                ///< that has been summed so far, s
  std::vector<Vec<D>> stress;         ///< filtered, at that time; empty before the first sample        Pa
  std::vector<double> pressure;       ///< at that time                                                 Pa
  std::vector<Vec<D>> stress_sum;     ///< int tau dt                                                   Pa s
  std::vector<double> magnitude_sum;  ///< int |tau| dt                                                 Pa s
  std::vector<double> pressure_sum;   ///< int p dt                                                     Pa s
};

template <int D>
void archive(Archive& a, WallCycle<D>& cycle);

template <int D>
struct CycleFields {
  std::int64_t number = 0;                   ///< from 0
  double duration = 0;                       ///< s
  std::vector<Vec<D>> mean_stress;           ///< Pa
  std::vector<double> tawss, mean_pressure;  ///< Pa

  /// -, 0 to 1/2; 0 where there is no stress.
  double osi(std::size_t a) const;
  /// 1/Pa; 0 where there is no stress.
  double rrt(std::size_t a) const;
};

/// Of the sum so far.
template <int D>
CycleFields<D> fields_of(const WallCycle<D>& cycle);

/// Whether a sample at `time` would end the running cycle; never with period 0.
template <int D>
bool ends(const WallCycle<D>& cycle, double time, double period);

/// Takes a sample at `time`; the first one only begins. Where a cycle has ended it returns that cycle's fields, else none
/// (`number` is -1). A sample interval may not be longer than a period; period 0: one cycle without end. `filter`: theta, s.
template <int D>
CycleFields<D> take(WallCycle<D>& cycle, double time, const std::vector<Vec<D>>& stress,
                    const std::vector<double>& pressure, double period, double filter);

}  // namespace ostium::sph3d
