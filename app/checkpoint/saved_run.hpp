/// Everything a coupled run goes on from: vessel and network, what was recorded, the account.
#pragma once
#include "app/results/account.hpp"
#include "app/results/recorder.hpp"
#include "app/vessel_output.hpp"
#include "coupling/state.hpp"

namespace ostium::app {

template <int D>
struct SavedRun {
  coupling::CoupledState<D> run;
  Recorded recorded;
  Account account;
  SavedVesselOutput<D> output;

  double time() const { return run.vessel.state.time; }
};

template <int D>
void archive(Archive& a, SavedRun<D>& saved);

}  // namespace ostium::app
