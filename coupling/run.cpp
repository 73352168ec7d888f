#include "coupling/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "coupling/datum.hpp"

namespace ostium::coupling {

namespace {

constexpr double flow_window = 2e-3;  // s, over which a port's flow is read

std::vector<sph3d::OpeningRole> roles_of(const network::Network& network,
                                         const std::vector<sph3d::Profile>& profiles) {
  std::vector<sph3d::OpeningRole> roles;
  for (int k = 0; k < network.port_count(); ++k)
    roles.push_back({network.kind(k) == network::PortKind::flow, profiles[k]});
  return roles;
}

template <int D>
VesselNumbers numbers_of(const sph3d::Model<D>& model, double wall_compliance) {
  return {.density = model.options.density,
          .sound_speed = model.options.sound_speed,
          .volume = model.domain.volume,
          .length = sph3d::length_between_openings(model.lumen),
          .wall_compliance = wall_compliance};
}

template <int D>
sph3d::Vessel<D> with_wall(sph3d::Vessel<D> vessel, const MakeWall<D>& make_wall) {
  if (make_wall) vessel.set_wall(make_wall(vessel.model()));
  return vessel;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

template <int D>
CoupledRun<D>::CoupledRun(network::Network network, const std::vector<sph3d::Profile>& profiles,
                          const MakeVessel& make, const CoupledOptions& options)
    : options_(options),
      network_(std::move(network)),
      vessel_(make(roles_of(network_, profiles))),
      scheme_(make_scheme(options.scheme, network_)) {
  const auto& fluid = vessel_.model().options;
  const double omega1 = options.period > 0 ? 2.0 * pi / options.period : 0.0;
  const double h = 1.3 * fluid.dp, acoustic = fluid.acoustic_cfl * h / fluid.sound_speed;
  const double advection =
      std::min(fluid.advection_cfl * h / fluid.reference_speed, fluid.most_acoustic_steps * acoustic);
  const double window = std::max(options.exchange, advection);
  stability_ = stability_numbers(
      network_, numbers_of(vessel_.model(), options.wall_compliance),
      {.window = window, .filter_time = options.filter_time, .delay = 4.0 * fluid.dp / fluid.sound_speed},
      omega1);
  warnings_ = check_stability(stability_, options.scheme, options.force);
}

template <int D>
CoupledRun<D>::CoupledRun(const sph3d::Lumen<D>& lumen, const sph3d::FluidOptions<D>& fluid,
                          const std::vector<sph3d::Profile>& profiles, network::Network network,
                          const std::optional<network::Start>& begin, const CoupledOptions& options,
                          const MakeWall<D>& make_wall)
    : CoupledRun(
          std::move(network), profiles,
          [&](auto roles) {
            return with_wall(
                sph3d::Vessel<D>(lumen, fluid, std::move(roles), options.background, options.progress),
                make_wall);
          },
          options) {
  start(begin);
}

template <int D>
CoupledRun<D>::CoupledRun(CoupledState<D> saved, const sph3d::Lumen<D>& lumen,
                          const sph3d::FluidOptions<D>& fluid, const std::vector<sph3d::Profile>& profiles,
                          network::Network network, const CoupledOptions& options,
                          const MakeWall<D>& make_wall)
    : CoupledRun(
          std::move(network), profiles,
          [&](auto roles) {
            return with_wall(sph3d::Vessel<D>(lumen, fluid, std::move(roles), std::move(saved.vessel)),
                             make_wall);
          },
          options) {
  network_.load(saved.network);
  scheme_->load(saved.scheme);
  carried_ = std::move(saved.exchanged);
}

template <int D>
CoupledState<D> CoupledRun<D>::save() const {
  return {vessel_.saved(), network_.save(), scheme_->save(), carried_};
}

template <int D>
void CoupledRun<D>::start(const std::optional<network::Start>& begin) {
  if (begin) network_.load(begin->state);
  const double omega1 = options_.period > 0 ? 2.0 * pi / options_.period : 0.0;
  std::vector<double> pressures;
  for (int k = 0; k < port_count(); ++k)
    pressures.push_back(network_.kind(k) == network::PortKind::pressure
                            ? options_.start_pressure.value_or(network_.pressure(k))
                            : 0.0);
  sph3d::PressureDatum datum{.background = options_.background,
                             .tau = options_.datum_time,
                             .weights = datum_weights(network_, omega1)};
  datum.start(pressures);
  vessel_.start_datum(datum);
  const double window = stability_.exchange.window;
  const Laws laws = scheme_->start(network_, window);
  carried_.drives.resize(laws.size());
  for (int k = 0; k < port_count(); ++k) {
    carried_.drives[k].law = laws[k];
    vessel_.port(k).filter = sph3d::ComplementaryFilter::started_at(0.0);
    carried_.volume_at_exchange.push_back(vessel_.volume_out(k));
  }
  update_drives();
  remember_flows();
}

template <int D>
void CoupledRun<D>::update_drives() {
  constexpr double dt = 1e-6;  // s, of the slope of a prescribed flow
  const double t = time(), rising = options_.ramp > 0 ? std::min(t / options_.ramp, 1.0) : 1.0;
  const double share = 0.5 * (1.0 - std::cos(pi * rising));
  for (int k = 0; k < port_count(); ++k) {
    if (network_.kind(k) != network::PortKind::flow) continue;
    const double now = network_.flow_into_vessel(k, t);
    carried_.drives[k].since = t;
    carried_.drives[k].flow_in = share * now;
    carried_.drives[k].flow_slope = rising < 1.0 ? 0.0 : (network_.flow_into_vessel(k, t + dt) - now) / dt;
  }
}

template <int D>
double CoupledRun<D>::next_stop(double t_end) const {
  return options_.exchange > 0 ? std::min(t_end, carried_.last_exchange + options_.exchange) : t_end;
}

template <int D>
sph3d::StepReport CoupledRun<D>::step(double t_end) {
  update_drives();
  const double stop = next_stop(t_end);
  const auto report = vessel_.advance(stop - time(), carried_.drives, options_.filter_time);
  remember_flows();
  if (options_.exchange <= 0 || time() >= stop - 1e-9 * std::max(stop, 1.0)) exchange();
  return report;
}

template <int D>
void CoupledRun<D>::exchange() {
  const double begin = seconds(), window = time() - carried_.last_exchange;
  std::vector<double> mean_flow;
  for (int k = 0; k < port_count(); ++k) {
    mean_flow.push_back((vessel_.volume_out(k) - carried_.volume_at_exchange[k]) / window);
    carried_.volume_at_exchange[k] = vessel_.volume_out(k);
  }
  const Laws laws = scheme_->exchange(network_, window, mean_flow);
  carried_.last_exchange = time();
  for (int k = 0; k < port_count(); ++k) {
    auto& port = vessel_.port(k);
    const double before = port.filter.q_counted;
    port.filter.step_counted(mean_flow[k], window, options_.filter_time);
    port.flow_rate = (port.filter.q_counted - before) / window;
    carried_.drives[k].law = laws[k];
    carried_.drives[k].since = time();
  }
  ++carried_.exchanges;
  carried_.network_seconds += seconds() - begin;
}

template <int D>
void CoupledRun<D>::remember_flows() {
  Sample sample{time(), {}, {}};
  for (int k = 0; k < port_count(); ++k) {
    const double before = carried_.recent.empty() ? 0.0 : carried_.recent.back().pressure[k];
    const double dt = carried_.recent.empty() ? 0.0 : time() - carried_.recent.back().time;
    sample.volume.push_back(vessel_.volume_out(k));
    sample.pressure.push_back(before + dt * vessel_.state().ports[k].pressure);
  }
  carried_.recent.push_back(std::move(sample));
  while (carried_.recent.size() > 2 && carried_.recent[1].time <= time() - flow_window)
    carried_.recent.erase(carried_.recent.begin());
}

template <int D>
PortReading CoupledRun<D>::port(int k) const {
  const Sample &first = carried_.recent.front(), &last = carried_.recent.back();
  const double span = last.time - first.time;
  return {.flow_out = span > 0 ? (last.volume[k] - first.volume[k]) / span : 0.0,
          .pressure =
              span > 0 ? (last.pressure[k] - first.pressure[k]) / span : vessel_.state().ports[k].pressure,
          .volume_out = vessel_.volume_out(k)};
}

template <int D>
double CoupledRun<D>::volume_inside() const {
  return vessel_.content();
}

template class CoupledRun<2>;
template class CoupledRun<3>;

}  // namespace ostium::coupling
