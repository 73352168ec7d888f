#include "sph3d/openings/ports.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

namespace {

/// Gives a particle its final velocity of the step; the second half of its drift follows it.
template <int D>
void set_velocity(FluidState<D>& fluid, Workspace<D>& work, std::int32_t i, const Vec<D>& v, double dt) {
  Cluster<D>& own = fluid.clusters[i / 8];
  const int lane = i % 8;
  float* record = &work.velocity[i].x;
  for (int d = 0; d < D; ++d) {
    own.moved[d][lane] += static_cast<float>(0.5 * dt * (v[d] - own.v[d][lane]));
    record[d] = own.v[d][lane] = static_cast<float>(v[d]);
  }
}

/// Inertance of the duct between the cap, where the law holds, and the outer face, where it is imposed; Pa.s2/m3.
/// Taking it out acts as a negative resistance inertance / filter_time on fast signals: only where the law has more.
template <int D>
double duct_inertia(const Model<D>& model, int k, double resistance, double filter_time) {
  const double inertance = model.options.density * model.ducts[k].length() / model.ducts[k].opening().area;
  return filter_time > 0.0 && inertance / filter_time < 0.5 * resistance ? inertance : 0.0;
}

template <int D>
void drive_by_pressure(const Model<D>& model, VesselState<D>& state, Workspace<D>& work, int k,
                       const Drive& drive, double dt, double filter_time) {
  const Vec<D>& n = model.ducts[k].opening().normal;
  PortState& port = state.ports[k];
  const double V = state.fluid.volume;
  const auto density_of = [&](const Zone<D>::Member& member) {
    return model.options.density * model.density_ratio(state.fluid.psi(member.index));
  };
  double q_tilde = 0, beta = 0, friction = 0;
  for (const auto& member : work.zones[k].members) {
    const double vn = state.fluid.velocity(member.index).dot(n);
    q_tilde += V * member.drive * vn;
    beta += V * member.drive * member.drive / density_of(member);
    friction += state.fluid.clusters[member.index / 8].friction[member.index % 8] * vn;
  }
  PortLaw law = port.filter.corrected(state.datum.relative(drive.law.at(state.time + dt - drive.since)));
  // what the pressure loses between the cap and the outer face
  const double in_duct = duct_inertia(model, k, drive.law.resistance, filter_time) * port.flow_rate +
                         model.options.density * (V * friction / model.ducts[k].opening().area -
                                                  model.options.gravity.dot(n) * model.ducts[k].length());
  law.p_star -= in_duct;
  port.face_pressure = implicit_port_pressure(law, q_tilde, beta * dt);
  port.pressure = port.face_pressure + in_duct + state.datum.reference;
  port.conjugate = q_tilde - beta * dt * port.face_pressure;
  port.filter.step_conjugate(port.conjugate, dt, filter_time);
  for (const auto& member : work.zones[k].members) {
    const double vn = state.fluid.velocity(member.index).dot(n) -
                      dt * port.face_pressure / density_of(member) * member.drive;
    set_velocity<D>(state.fluid, work, member.index, vn * n, dt);
  }
}

/// The counted volume lags what was asked for by round-off, arrival noise and the profile's discrete mean; a
/// slow return.
double trim(const PortState& port, double flow_scale) {
  constexpr double return_time = 0.02, largest = 0.05;
  const double behind = port.asked - (port.counted - port.counted_at_start);
  return std::clamp(behind / return_time, -largest * flow_scale, largest * flow_scale);
}

template <int D>
void drive_by_flow(const Model<D>& model, VesselState<D>& state, Workspace<D>& work, int k,
                   const Drive& drive, double dt) {
  const Opening<D>& opening = model.ducts[k].opening();
  PortState& port = state.ports[k];
  const double out = -(drive.flow_in + drive.flow_slope * (state.time + dt - drive.since));
  port.flow_scale = std::max(port.flow_scale * std::exp(-dt), std::abs(out));
  const double mean = (out + trim(port, port.flow_scale)) / opening.area;
  port.asked += dt * out;
  port.conjugate = out;
  for (const auto& member : work.zones[k].members)
    set_velocity<D>(state.fluid, work, member.index, mean * member.drive * opening.normal, dt);
}

}  // namespace

template <int D>
void drive_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work,
                 std::span<const Drive> drives, double dt, double filter_time) {
  std::vector<double> pressures(drives.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t k = 0; k < drives.size(); ++k) {
    if (model.roles[k].flow_driven)
      drive_by_flow(model, state, work, static_cast<int>(k), drives[k], dt);
    else
      drive_by_pressure(model, state, work, static_cast<int>(k), drives[k], dt, filter_time);
    pressures[k] = state.ports[k].pressure;
  }
  state.datum.step(dt, pressures);
}

template void drive_ports(const Model<2>&, VesselState<2>&, Workspace<2>&, std::span<const Drive>, double,
                          double);
template void drive_ports(const Model<3>&, VesselState<3>&, Workspace<3>&, std::span<const Drive>, double,
                          double);

}  // namespace ostium::sph3d
