/// Gives the openings the names the case chose. Internal to geometry/.
#pragma once
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/uneven_ends.hpp"

namespace ostium::sph3d {

/// Refuses a choice that falls on one of the ends that are not plane.
void name_openings(std::vector<Opening<3>>& openings, const std::vector<OpeningChoice>& choices,
                   const std::vector<UnevenEnd>& uneven = {});

/// One line per opening.
std::string table(const std::vector<Opening<3>>& openings);

}  // namespace ostium::sph3d
