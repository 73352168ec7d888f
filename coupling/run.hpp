/// A vessel and its network in step: the coupled run.
///
///   every advection step      the vessel moves, each opening answering its law at its own new flow
///   every exchange            the counted volumes become mean flows, the network advances, new laws come back
///
///        vessel --- Q_k = dM_k/dt ---> network
///        vessel <-- P_k(t) law ------- network           flow ports: the network prescribes the flow instead
///
/// The run starts from the network's state, with the blood at rest and prescribed flows rising from zero within `ramp`.
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
#include "network/network.hpp"
#include "network/periodic.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::coupling {

struct CoupledOptions {
  SchemeKind scheme = SchemeKind::linearised;
  double exchange = 0, filter_time = 0.01, datum_time = 0.005, ramp = 0.01;
  double period = 0;                          // s, of the heart; 0 where there is none
  double background = 0;                      // Pa, p_b
  bool force = false;                         // run an unstable choice all the same
  std::function<void(double)> progress = {};  // share of the filling done
};

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
             const std::optional<network::Start>& start, const CoupledOptions& options);

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
  std::int64_t exchanges() const { return exchanges_; }
  double network_seconds() const { return network_seconds_; }

 private:
  void start(const std::optional<network::Start>& start);
  double next_stop(double t_end) const;
  void update_drives();
  void exchange();
  void remember_flows();

  CoupledOptions options_;
  network::Network network_;
  sph3d::Vessel<D> vessel_;
  std::unique_ptr<Scheme> scheme_;
  std::vector<sph3d::Drive> drives_;
  std::vector<double> volume_at_exchange_;
  double last_exchange_ = 0;
  std::int64_t exchanges_ = 0;
  double network_seconds_ = 0;
  StabilityNumbers stability_;
  std::vector<std::string> warnings_;

  struct Sample {
    double time;
    std::vector<double> volume;    // m3, out
    std::vector<double> pressure;  // Pa s, integrated since the start
  };
  std::vector<Sample> recent_;  // of the last milliseconds, oldest first
};

extern template class CoupledRun<2>;
extern template class CoupledRun<3>;

}  // namespace ostium::coupling
