/// What a coupled run goes on from: both halves, and what it carries between them. Plain data.
#pragma once
#include <cstdint>
#include <vector>

#include "coupling/scheme.hpp"
#include "network/network.hpp"
#include "sph3d/step/state.hpp"

namespace ostium {
class Archive;
}

namespace ostium::coupling {

/// What has left through the ports by a time, for means over the last milliseconds.
struct Sample {
  double time = 0;               // s
  std::vector<double> volume;    // m3, out
  std::vector<double> pressure;  // Pa s, integrated since the start
};

/// What the run carries from step to step beside its two halves.
struct Exchanged {
  std::vector<sph3d::Drive> drives;        // one per port
  std::vector<double> volume_at_exchange;  // m3
  double last_exchange = 0;                // s
  std::int64_t exchanges = 0;
  double network_seconds = 0;  // s of wall time
  std::vector<Sample> recent;  // oldest first
};

template <int D>
struct CoupledState {
  sph3d::SavedVessel<D> vessel;
  network::State network;
  SchemeState scheme;
  Exchanged exchanged;
};

template <int D>
void archive(Archive& a, CoupledState<D>& state);

}  // namespace ostium::coupling
