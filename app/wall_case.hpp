/// The wall of the vessel as the case describes it.
///
///   wall: {model: shell, thickness: 2.5 mm, material: {law: neo_hookean, E: 0.75 MPa, nu: 0.49}, ends: clamped}
///
/// All values are SI. Checked here: each field by itself, and which belong to which model and law. Not checked here: what the
/// surface is bent like, whether the exchange with the blood is stable (app/wall_setup).
#pragma once
#include <optional>
#include <string>

#include "core/config.hpp"
#include "sph3d/shell/generate.hpp"

namespace ostium::app {

enum class WallModel { rigid, shell, solid };
enum class WallLaw { saint_venant_kirchhoff, neo_hookean, holzapfel };

struct MaterialCase {
  WallLaw law = WallLaw::saint_venant_kirchhoff;
  double E = 0, nu = 0;                 // Pa, -
  std::optional<double> k1, k2, kappa;  // Pa, -, -
  std::optional<double> fibre_angle;    // rad, to the circumference
};

/// Linear in the distance from an opening, or a point array of the surface file: thickness in m, or a factor on the stiffness.
enum class Varies { thickness, stiffness };
template <Varies>
struct VaryingCase {
  std::optional<std::string> array, opening;
  std::optional<double> at_opening, away, length;  // length: m
  config::Node origin;
};

struct SupportCase {
  double spring = 0, dashpot = 0;  // Pa/m, Pa s/m
};

struct PrestressCase {
  double pressure = 0;  // Pa
};

struct WallCase {
  WallModel model = WallModel::rigid;
  std::optional<double> thickness;  // m
  std::optional<VaryingCase<Varies::thickness>> varying_thickness;
  std::optional<VaryingCase<Varies::stiffness>> varying_stiffness;
  std::optional<MaterialCase> material;
  std::optional<double> density, spacing, clamp_length;  // kg/m3, m, m
  std::optional<sph3d::WallEnds> ends;
  std::optional<SupportCase> support;
  std::optional<PrestressCase> prestress;
  std::optional<double> outside_pressure, viscosity;  // Pa, Pa s
  std::optional<int> gauss_points;
  config::Node origin;
};

void declare(config::Fields<MaterialCase>&);
void declare(config::Fields<VaryingCase<Varies::thickness>>&);
void declare(config::Fields<VaryingCase<Varies::stiffness>>&);
void declare(config::Fields<SupportCase>&);
void declare(config::Fields<PrestressCase>&);
void declare(config::Fields<WallCase>&);

}  // namespace ostium::app
