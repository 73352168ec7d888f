/// The parameters of the generated vessels as declared fields: options of `ostium geometry`, with units and ranges.
#pragma once
#include "core/config.hpp"
#include "sph3d/geometry/generate.hpp"

namespace ostium::sph3d {

void declare(config::Fields<TubeShape>&);
void declare(config::Fields<BendShape>&);
void declare(config::Fields<BifurcationShape>&);
void declare(config::Fields<ArchShape>&);

}  // namespace ostium::sph3d
