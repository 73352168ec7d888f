/// Gives the openings the names the case chose. Internal to geometry/.
#pragma once
#include "sph3d/geometry/read.hpp"

namespace ostium::sph3d {

void name_openings(std::vector<Opening<3>>& openings, const std::vector<OpeningChoice>& choices);

/// One line per opening.
std::string table(const std::vector<Opening<3>>& openings);

}  // namespace ostium::sph3d
