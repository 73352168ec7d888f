#include "lumped/structured_tree.hpp"

#include <cmath>
#include <numbers>

namespace ostium::lumped {

void StructuredTree::prepare() {
  tree = {r_root, r_min, xi, eta, length_ratio, k1, k2, k3, density, viscosity};
  std::vector<ImpedanceSample> samples{{0, impedance(tree, 0)}};
  constexpr int per_decade = 10, decades = 3;
  for (int n = -per_decade * decades; n <= 0; ++n) {
    const double omega = 2 * std::numbers::pi * f_max * std::pow(10.0, static_cast<double>(n) / per_decade);
    samples.push_back({omega, impedance(tree, omega)});
  }
  fit(samples);
}

namespace {

std::string check_tree(const StructuredTree& t) {
  if (t.r_min >= t.r_root)
    return fmt::format("\"r_min\" is {:g} m and \"r_root\" {:g} m: a tree needs r_min < r_root", t.r_min,
                       t.r_root);
  const double generations = std::log(t.r_min / t.r_root) / std::log(Tree{.xi = t.xi, .eta = t.eta}.alpha());
  const double womersley = t.r_root * std::sqrt(2 * std::numbers::pi * t.f_max * t.density / t.viscosity);
  if (womersley > 300)
    return fmt::format(
        "the root has the Womersley number {:.3g} at \"f_max\", at most 300 is allowed; look at the units of "
        "\"r_root\", "
        "\"f_max\", \"density\" and \"viscosity\"",
        womersley);
  if (generations > 200)
    return fmt::format(
        "from {:g} m to {:g} m the tree has {:.0f} generations, at most 200 are allowed; raise "
        "\"r_min\", or lower \"xi\" or raise \"eta\"",
        t.r_root, t.r_min, generations);
  return {};
}

}  // namespace

void declare(config::Fields<StructuredTree>& f) {
  using S = StructuredTree;
  declare_outlet(f);
  f.quantity("r_root", &S::r_root, "m", "radius of the root").positive();
  f.quantity("r_min", &S::r_min, "m", "radius below which a vessel is the last one").positive();
  f.number("xi", &S::xi, "exponent of the power law of radii").at_least(1).at_most(4).or_else(2.76);
  f.number("eta", &S::eta, "ratio of the areas of the two daughters").positive().at_most(1).or_else(0.41);
  f.number("length_ratio", &S::length_ratio, "length of a vessel over its radius").positive().or_else(50);
  f.quantity("k1", &S::k1, "Pa", "stiffness Eh/r of the wall: part that falls with the radius")
      .non_negative()
      .or_else(2e6);
  f.quantity("k2", &S::k2, "1/m", "its exponent").or_else(-2253);
  f.quantity("k3", &S::k3, "Pa", "stiffness Eh/r of large vessels").positive().or_else(8.65e4);
  f.quantity("density", &S::density, "kg/m3", "density of blood").positive().or_else(1060);
  f.quantity("viscosity", &S::viscosity, "Pa.s", "dynamic viscosity of blood").positive().or_else(0.004);
  f.quantity("f_max", &S::f_max, "Hz", "highest frequency at which the impedance is met")
      .positive()
      .or_else(20);
  f.check(check_tree);
}

}  // namespace ostium::lumped
