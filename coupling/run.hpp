/// A vessel and its network in step: the coupled run.
///
///   every advection step      the vessel moves, each opening answering its law at its own new flow
///   every exchange            the counted volumes become mean flows, the network advances, new laws come back
///
///        vessel --- Q_k = dM_k/dt ---> network
///        vessel <-- P_k(t) law ------- network           flow ports: the network prescribes the flow instead
///
/// The run starts from the network's state, with the blood at rest at its pressure or at `start_pressure`, and prescribed flows
/// rising from zero within `ramp`.
/// The datum of the fluid's pressure moves with the ports (docs/theory/coupling.md).
///
///   exchange      s   shortest interval between two exchanges; 0: every advection step
///   filter_time   s   of the ports' complementary filter
///   datum_time    s   tau_D; 0: the datum stays where it starts, and the fluid stores what it stores
///   ramp          s   over which prescribed flows rise at the start
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "coupling/scheme.hpp"
#include "coupling/stability.hpp"
#include "coupling/state.hpp"
#include "network/network.hpp"
#include "network/periodic.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::coupling {

struct CoupledOptions {
  SchemeKind scheme = SchemeKind::linearised;
  double exchange = 0, filter_time = 0.01, datum_time = 0.005, ramp = 0.01;
  double period = 0;                          // s, of the heart; 0 where there is none
  double background = 0;                      // Pa, p_b
  std::optional<double> start_pressure = {};  // Pa, of the blood; without it that of the network
  double wall_compliance = 0;                 // m3/Pa, of walls that move
  bool force = false;                         // run an unstable choice all the same
  std::function<void(double)> progress = {};  // share of the filling done
};

/// Makes the wall of a vessel whose walls move; empty where they are rigid.
template <int D>
using MakeWall = std::function<std::unique_ptr<sph3d::DeformableWall<D>>(const sph3d::Model<D>&)>;

/// What an opening shows after a step; flow and pressure are means over the last two milliseconds.
struct PortReading {
  double flow_out = 0;    // m3/s
  double pressure = 0;    // Pa, physical
  double volume_out = 0;  // m3
};

template <int D>
class CoupledRun {
 public:
  CoupledRun(const sph3d::Lumen<D>& lumen, const sph3d::FluidOptions<D>& fluid,
             const std::vector<sph3d::Profile>& profiles, network::Network network,
             const std::optional<network::Start>& start, const CoupledOptions& options,
             const MakeWall<D>& make_wall = {});

  /// Goes on where a run of the same case was saved, with the same bits.
  CoupledRun(CoupledState<D> saved, const sph3d::Lumen<D>& lumen, const sph3d::FluidOptions<D>& fluid,
             const std::vector<sph3d::Profile>& profiles, network::Network network,
             const CoupledOptions& options, const MakeWall<D>& make_wall = {});
  CoupledState<D> save() const;

  /// One advection step, not beyond t_end; then an exchange if one is due.
  sph3d::StepReport step(double t_end);

  double time() const { return vessel_.time(); }
  PortReading port(int k) const;
  int port_count() const { return network_.port_count(); }
  /// Volume between the measuring planes, m3; its change plus what left is zero to round-off.
  double volume_inside() const;

  const sph3d::Vessel<D>& vessel() const { return vessel_; }
  const network::Network& network() const { return network_; }
  const StabilityNumbers& stability() const { return stability_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  std::int64_t exchanges() const { return carried_.exchanges; }
  double network_seconds() const { return carried_.network_seconds; }

 private:
  using MakeVessel = std::function<sph3d::Vessel<D>(std::vector<sph3d::OpeningRole>)>;
  CoupledRun(network::Network network, const std::vector<sph3d::Profile>& profiles, const MakeVessel& make,
             const CoupledOptions& options);
  void start(const std::optional<network::Start>& start);
  double next_stop(double t_end) const;
  void update_drives();
  void exchange();
  void remember_flows();

  CoupledOptions options_;
  network::Network network_;
  sph3d::Vessel<D> vessel_;
  std::unique_ptr<Scheme> scheme_;
  Exchanged carried_;
  StabilityNumbers stability_;
  std::vector<std::string> warnings_;
};

extern template class CoupledRun<2>;
extern template class CoupledRun<3>;

}  // namespace ostium::coupling
