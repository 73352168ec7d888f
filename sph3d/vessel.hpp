/// A vessel full of blood: what the coupling sees of the 3D (or 2D) side.
///
///   advance(dt, drives)  moves the fluid by one advection step of at most dt; then the counters say what
///   left through each
///                        opening.
///
///   Every opening is driven by a flow (with its profile) or by a pressure law. Flows and volumes are
///   positive when leaving the vessel; pressures are relative to the datum of the fluid solver, in Pa. A 2D
///   vessel is one metre deep.
///
/// Source: docs/theory/fluid.md ("One advection step"), docs/theory/openings.md.
#pragma once
#include <functional>
#include <memory>
#include <span>

#include "sph3d/step/model.hpp"
#include "sph3d/step/phases.hpp"
#include "sph3d/step/state.hpp"
#include "sph3d/step/workspace.hpp"
#include "sph3d/walls/deformable_wall.hpp"

namespace ostium::sph3d {

struct StepReport {
  double dt = 0;  ///< s
  int acoustic_steps = 0;
  double max_speed = 0;          ///< outside the ducts, m/s
  double kinetic_energy = 0;     ///< J
  double max_density_error = 0;  ///< largest |psi| outside the ducts
  std::size_t particles = 0;
  StepBound bound = StepBound::none;
  std::int64_t leaked = 0;       ///< particles that went through the wall, and were put back
  std::array<double, 3> leak{};  ///< where the first of them was before, m
  PhaseSeconds seconds{};        ///< of this step
};

template <int D>
class Vessel {
 public:
  /// Fills the vessel with fluid at rest and uniform pressure. One role per opening of the lumen.
  Vessel(const Lumen<D>& lumen, const FluidOptions<D>& options, std::vector<OpeningRole> roles,
         double pressure = 0, const std::function<void(double)>& progress = {});

  /// Goes on where another vessel with the same lumen, options and roles was saved, with the same bits.
  Vessel(const Lumen<D>& lumen, const FluidOptions<D>& options, std::vector<OpeningRole> roles,
         SavedVessel<D> saved);

  /// One advection step of at most dt_limit (s), one drive per opening; filter_time (s): of the ports'
  /// filters.
  StepReport advance(double dt_limit, std::span<const Drive> drives, double filter_time);

  const Model<D>& model() const { return *model_; }
  const VesselState<D>& state() const { return state_; }
  const Workspace<D>& workspace() const { return work_; }
  VesselState<D> save() const { return state_; }
  SavedVessel<D> saved() const { return {state_, model_->number_density, model_->rest_volume}; }
  void load(VesselState<D> state) { state_ = std::move(state); }

  /// The wall moves from now on: before the first step, or from where its state was saved.
  void set_wall(std::unique_ptr<DeformableWall<D>> wall);
  const DeformableWall<D>* wall() const { return wall_.get(); }

  /// The part of the ports' pressures the fluid does not see; must be set before the first step (see PressureDatum).
  void start_datum(const PressureDatum& datum);

  double time() const { return state_.time; }
  double volume_out(int port) const {
    return state_.ports[port].counted - state_.ports[port].counted_at_start;
  }
  const PortState& port(int port) const { return state_.ports[port]; }
  PortState& port(int port) { return state_.ports[port]; }
  /// Volume of the blood between the caps, at rho0, m3: what came in less what went out, to round-off.
  double content() const;
  /// Volume the compressible fluid stores per unit of pressure, V / (rho0 c^2), m3/Pa.
  double storage() const;
  std::size_t bytes() const;

 private:
  double acoustic_time_step() const;
  std::pair<double, StepBound> time_step(double dt_limit) const;
  void prepare(double dt, double acoustic_dt, PhaseSeconds& seconds);
  void acoustic_step(double dt, bool last, std::span<const Drive> drives, double filter_time,
                     PhaseSeconds& seconds);
  StepReport move();
  void stop_leak(const std::vector<std::size_t>& gone);

  std::unique_ptr<const Model<D>> model_;
  std::unique_ptr<DeformableWall<D>> wall_;  // null where it is rigid
  VesselState<D> state_;
  Workspace<D> work_;
};

extern template class Vessel<2>;
extern template class Vessel<3>;

}  // namespace ostium::sph3d
