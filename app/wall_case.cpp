// The keys of `vessel.wall`: name, unit, range, default and meaning of each.
#include "app/wall_case.hpp"

#include <fmt/format.h>

namespace ostium::app {
namespace {

std::string check_material(const MaterialCase& m) {
  const bool any = m.k1 || m.k2 || m.kappa || m.fibre_angle;
  if (m.law != WallLaw::holzapfel)
    return any ? "\"k1\", \"k2\", \"kappa\" and \"fibre_angle\" belong to the fibres of \"law: holzapfel\""
               : "";
  return m.k1 && m.k2 ? ""
                      : "the law \"holzapfel\" needs \"k1\" and \"k2\" of its fibres; add for example \"k1: "
                        "50 kPa, k2: 10\"";
}

template <Varies V>
std::string check_varying(const VaryingCase<V>& v) {
  const bool whole = v.opening && v.at_opening && v.away && v.length,
             any = v.opening || v.at_opening || v.away || v.length;
  if (v.array ? !any : whole) return {};
  return "what varies over the wall is given either by \"array\", a point array of the surface file, or by "
         "all of \"opening\", "
         "\"at_opening\", \"away\" and \"length\"";
}

/// What a rigid wall has no use for.
std::string given(const WallCase& w) {
  const std::pair<const char*, bool> keys[] = {{"thickness", w.thickness.has_value()},
                                               {"varying_thickness", w.varying_thickness.has_value()},
                                               {"varying_stiffness", w.varying_stiffness.has_value()},
                                               {"material", w.material.has_value()},
                                               {"density", w.density.has_value()},
                                               {"spacing", w.spacing.has_value()},
                                               {"clamp_length", w.clamp_length.has_value()},
                                               {"ends", w.ends.has_value()},
                                               {"support", w.support.has_value()},
                                               {"prestress", w.prestress.has_value()},
                                               {"outside_pressure", w.outside_pressure.has_value()},
                                               {"viscosity", w.viscosity.has_value()},
                                               {"gauss_points", w.gauss_points.has_value()}};
  for (const auto& [key, there] : keys)
    if (there) return key;
  return {};
}

/// What a shell has and a solid has not.
std::string check_solid(const WallCase& w) {
  const std::pair<const char*, bool> lacking[] = {{"varying_thickness", w.varying_thickness.has_value()},
                                                  {"varying_stiffness", w.varying_stiffness.has_value()},
                                                  {"support", w.support.has_value()},
                                                  {"prestress", w.prestress.has_value()},
                                                  {"gauss_points", w.gauss_points.has_value()}};
  for (const auto& [key, there] : lacking)
    if (there)
      return fmt::format("a solid wall has no \"{}\"; remove the key, or write \"model: shell\"", key);
  if (!w.thickness) return "a solid wall needs its \"thickness\"; write for example \"thickness: 2 mm\"";
  if (!w.material)
    return "a solid wall needs its \"material\"; write for example \"material: {law: neo_hookean, E: 0.75 "
           "MPa, nu: 0.49}\"";
  if (w.material->law == WallLaw::holzapfel)
    return "a solid wall has no fibres; take the law \"neo_hookean\", or write \"model: shell\"";
  if (w.ends && *w.ends != sph3d::WallEnds::clamped)
    return "the ends of a solid wall are clamped; remove \"ends\", or write \"model: shell\"";
  return {};
}

std::string check_wall(const WallCase& w) {
  if (w.model == WallModel::rigid) {
    const std::string key = given(w);
    return key.empty() ? ""
                       : "a rigid wall has no \"" + key +
                             "\"; write \"model: shell\" for a wall that moves, or remove the key";
  }
  if (w.model == WallModel::solid) return check_solid(w);
  if (w.thickness.has_value() == w.varying_thickness.has_value())
    return "a shell needs either \"thickness\" or \"varying_thickness\"; write for example \"thickness: 2 "
           "mm\"";
  if (w.gauss_points == 4)
    return "\"gauss_points\" is 4; through the thickness 1, 2, 3 or 5 are possible, write for example "
           "\"gauss_points: 5\"";
  if (!w.material)
    return "a shell needs its \"material\"; write for example \"material: {law: neo_hookean, E: 0.75 MPa, "
           "nu: 0.49}\"";
  return {};
}

template <Varies V>
void declare_varying(config::Fields<VaryingCase<V>>& f) {
  using Case = VaryingCase<V>;
  f.text("array", &Case::array,
         "point array of the surface file (VTP), linear over each triangle; a thickness is in `length_unit`");
  f.text("opening", &Case::opening, "the opening from whose rim the distance counts");
  const auto value = [&](const char* name, auto member, const char* doc) {
    if constexpr (V == Varies::thickness)
      f.quantity(name, member, "m", doc).positive();
    else
      f.number(name, member, doc).positive();
  };
  value("at_opening", &Case::at_opening, "value at the rim");
  value("away", &Case::away, "value from `length` on");
  f.quantity("length", &Case::length, "m", "distance over which it changes").positive();
  f.origin(&Case::origin);
  f.check(check_varying<V>);
}

}  // namespace

void declare(config::Fields<MaterialCase>& f) {
  f.choice("law", &MaterialCase::law,
           {{"saint_venant_kirchhoff", WallLaw::saint_venant_kirchhoff},
            {"neo_hookean", WallLaw::neo_hookean},
            {"holzapfel", WallLaw::holzapfel}},
           "small strains; rubber; arteries with two families of stiffening fibres (Holzapfel-Gasser-Ogden)")
      .or_else(WallLaw::saint_venant_kirchhoff);
  f.quantity("E", &MaterialCase::E, "Pa", "Young's modulus at small strain, of the rubber without its fibres")
      .positive();
  f.number("nu", &MaterialCase::nu, "Poisson's ratio; nearly incompressible walls have 0.49")
      .at_least(0)
      .below(0.5);
  f.quantity("k1", &MaterialCase::k1, "Pa", "holzapfel: stiffness of the fibres").positive();
  f.number("k2", &MaterialCase::k2, "holzapfel: how fast they stiffen").positive();
  f.number("kappa", &MaterialCase::kappa,
           "holzapfel: dispersion, 0 (without it) all in one direction, 1/3 in all alike")
      .at_least(0)
      .at_most(1.0 / 3.0);
  f.quantity("fibre_angle", &MaterialCase::fibre_angle, "rad",
             "holzapfel: of both families to the circumference; without it 40 degrees")
      .at_least(0)
      .at_most(1.5708);
  f.check(check_material);
}

void declare(config::Fields<VaryingCase<Varies::thickness>>& f) { declare_varying(f); }
void declare(config::Fields<VaryingCase<Varies::stiffness>>& f) { declare_varying(f); }

void declare(config::Fields<SupportCase>& f) {
  f.quantity("spring", &SupportCase::spring, "Pa/m", "stiffness of the tissue per area of wall")
      .non_negative()
      .or_else(0);
  f.quantity("dashpot", &SupportCase::dashpot, "Pa.s/m", "its resistance to motion per area of wall")
      .non_negative()
      .or_else(0);
}

void declare(config::Fields<PrestressCase>& f) {
  f.quantity("pressure", &PrestressCase::pressure, "Pa",
             "of the blood at which the wall has the shape of the image");
}

void declare(config::Fields<WallCase>& f) {
  f.choice("model", &WallCase::model,
           {{"rigid", WallModel::rigid}, {"shell", WallModel::shell}, {"solid", WallModel::solid}},
           "rigid; a thin elastic shell that moves with the blood; the same wall in its full thickness, to "
           "compare with")
      .or_else(WallModel::rigid);
  f.quantity("thickness", &WallCase::thickness, "m",
             "shell, solid: thickness of the wall, outwards from the surface")
      .positive();
  f.section("varying_thickness", &WallCase::varying_thickness,
            "shell: a thickness that is not the same everywhere");
  f.section("varying_stiffness", &WallCase::varying_stiffness,
            "shell: factor on the material's stress, likewise");
  f.section("material", &WallCase::material, "shell, solid: what the wall is made of");
  f.quantity("density", &WallCase::density, "kg/m3",
             "shell, solid: density of the wall; without it 1100 kg/m3")
      .positive();
  f.quantity(
       "spacing", &WallCase::spacing, "m",
       "shell, solid: spacing of its particles; without it that of the blood, the coarsest allowed, of a "
       "solid a quarter of the thickness where that is less")
      .positive();
  f.choice("ends", &WallCase::ends,
           {{"clamped", sph3d::WallEnds::clamped},
            {"released", sph3d::WallEnds::released},
            {"free", sph3d::WallEnds::free}},
           "shell: at the openings the wall neither moves nor turns (without the key), may widen but not "
           "move along, or is not held");
  f.quantity(
       "clamp_length", &WallCase::clamp_length, "m",
       "shell, solid: how far inside its opening an end is held; without it the reach of the blood's kernel "
       "and one row")
      .positive();
  f.section("support", &WallCase::support, "shell: tissue around the vessel");
  f.section("prestress", &WallCase::prestress,
            "shell: the image shows the vessel under pressure; stresses are found that keep that shape at "
            "this pressure. Without it "
            "the shape of the image is free of stress");
  f.quantity("outside_pressure", &WallCase::outside_pressure, "Pa",
             "shell, solid: pressure of the tissue; without it 0");
  f.quantity("viscosity", &WallCase::viscosity, "Pa.s",
             "shell, solid: of the wall's own (Kelvin-Voigt); without it 0")
      .non_negative();
  f.integer("gauss_points", &WallCase::gauss_points,
            "shell: through the thickness, 1 (a membrane), 2, 3 or 5; without it 3")
      .at_least(1)
      .at_most(5);
  f.origin(&WallCase::origin);
  f.check(check_wall);
}

}  // namespace ostium::app
