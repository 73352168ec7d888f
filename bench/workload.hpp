/// What the benchmark runs: a straight tube of about so many particles, or a vessel from a file.
#pragma once
#include <filesystem>

#include "sph3d/vessel.hpp"

namespace ostium::bench {

/// A tube 20 particles across with an inflow and an outlet of fixed pressure, stepped until it flows.
sph3d::Vessel<3> flowing_tube(int particles);

/// The surface (lengths in cm) at 1 mm, all openings but the largest at fixed pressure; blood at systolic speed.
sph3d::Vessel<3> flowing_aorta(const std::filesystem::path& surface);

/// A generated arch of about the same size.
sph3d::Vessel<3> flowing_arch();

std::vector<sph3d::Drive> drives_of(const sph3d::Vessel<3>& vessel);

}  // namespace ostium::bench
