#include "app/coupled.hpp"

#include "app/vessel_setup.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

template <int D>
int run(const Case& study, const RunOptions&) {
  const Setup<D> setup = set_up<D>(study);
  // coupling::run(study, setup, recorder) goes here.
  study.vessel->origin.error(
      "this build cannot run a case with a vessel yet; \"ostium check\" and \"ostium preview\" can");
}

}  // namespace

int run_coupled(const Case& study, const RunOptions& options) {
  return study.vessel->dimension == 2 ? run<2>(study, options) : run<3>(study, options);
}

}  // namespace ostium::app
