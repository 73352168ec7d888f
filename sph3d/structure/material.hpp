/// The laws a wall can be made of.
///
///   law                    for
///   SaintVenantKirchhoff   small strain, large rotation; what the literature's benchmarks use
///   NeoHookean             large strain, nearly incompressible
///   Holzapfel              arteries: stiffening fibres
///
/// Each gives stress(E), energy(E), thickness_stress(E), moduli() and plate_modulus(stretch) for numbers and for lanes. Kernels
/// are templates over the law; a Material is the choice made at run time, taken apart once per step:
///
///   std::visit([&](const auto& law) { ... law.stress(E, fibres) ... }, material);
///
/// A stiffness that varies over the wall is a factor on the stress, the same for all terms of a law. Source:
/// docs/theory/materials.md.
#pragma once
#include <variant>

#include "sph3d/structure/holzapfel.hpp"
#include "sph3d/structure/neo_hookean.hpp"
#include "sph3d/structure/plane_stress.hpp"
#include "sph3d/structure/saint_venant_kirchhoff.hpp"

namespace ostium::sph3d {

using Material = std::variant<SaintVenantKirchhoff, NeoHookean, Holzapfel>;

inline Moduli moduli(const Material& material) {
  return std::visit([](const auto& law) { return law.moduli(); }, material);
}

}  // namespace ostium::sph3d
