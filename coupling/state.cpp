#include "coupling/state.hpp"

#include "core/archive.hpp"
#include "sph3d/step/archive.hpp"

namespace ostium::coupling {

namespace {

void archive(Archive& a, Exchanged& x) {
  a.list("drives", x.drives, [&](sph3d::Drive& drive) { sph3d::archive(a, drive); });
  a("volume_at_exchange", x.volume_at_exchange);
  a("last_exchange", x.last_exchange);
  a("exchanges", x.exchanges);
  a("network_seconds", x.network_seconds);
  a.list("recent", x.recent, [&](Sample& sample) {
    a("time", sample.time);
    a("volume", sample.volume);
    a("pressure", sample.pressure);
  });
}

}  // namespace

template <int D>
void archive(Archive& a, CoupledState<D>& state) {
  a.part("vessel", [&] { sph3d::archive(a, state.vessel); });
  a.part("network", [&] { network::archive(a, state.network); });
  a.part("scheme", [&] {
    a("pressure", state.scheme.pressure);
    a("flow", state.scheme.flow);
  });
  a.part("exchanged", [&] { archive(a, state.exchanged); });
}

template void archive(Archive&, CoupledState<2>&);
template void archive(Archive&, CoupledState<3>&);

}  // namespace ostium::coupling
