/// From the case file to a checked vessel and network that fit each other, before anything is written or run.
///
///   particles across = width of an opening / spacing; fewer than 4 are refused, fewer than 8 warned of
///
/// Throws UserError with the position in the case file.
#pragma once
#include <vector>

#include "app/case.hpp"
#include "app/probes.hpp"
#include "app/wall_plan.hpp"
#include "network/network.hpp"
#include "network/periodic.hpp"
#include "sph3d/geometry/lumen.hpp"

namespace ostium::app {

inline constexpr double least_particles_across = 4, good_particles_across = 8;

/// The lumen with the openings named by the case.
template <int D>
sph3d::Lumen<D> read_vessel(const VesselCase& vessel);

template <int D>
void check_spacing(const VesselCase& vessel, const sph3d::Lumen<D>& lumen);

/// One port per opening, in the order of the lumen.
template <int D>
std::vector<network::Port> ports_of(const sph3d::Lumen<D>& lumen);

template <int D>
struct Setup {
  sph3d::Lumen<D> lumen;
  network::Model model;
  std::vector<network::Port> ports;
  std::vector<network::PortKind> kinds;  // of each port
  std::vector<sph3d::Profile> profiles;  // of each opening
  std::optional<WallPlan<D>> wall;       // where it moves
  std::vector<Probe<D>> probes;
};

/// Everything a coupled run needs; the graph has been checked against the openings.
template <int D>
Setup<D> set_up(const Case& study);

/// The periodic state of the network, where the case starts from it.
std::optional<network::Start> start_of(const Case& study, const network::Model& model,
                                       const std::vector<network::Port>& ports);

/// Particles that fill the lumen without its ducts.
template <int D>
double particle_count(const Case& study, const sph3d::Lumen<D>& lumen);

}  // namespace ostium::app
