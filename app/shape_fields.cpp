#include "app/shape_fields.hpp"

namespace ostium::sph3d {
namespace {

template <class S>
void length(config::Fields<S>& f, const char* name, double S::*member, const char* doc) {
  f.quantity(name, member, "m", doc).positive().or_else(S{}.*member);
}

/// 0 stands for "as the shape decides".
template <class S>
void optional_length(config::Fields<S>& f, const char* name, double S::*member, const char* doc) {
  f.quantity(name, member, "m", doc).non_negative().or_else(S{}.*member);
}

template <class S>
void angle(config::Fields<S>& f, const char* name, double S::*member, const char* doc) {
  f.quantity(name, member, "rad", doc).positive().or_else(S{}.*member);
}

template <class S>
void sides(config::Fields<S>& f) {
  f.integer("around", &S::around, "sides of the polygon that stands for the circle")
      .at_least(6)
      .at_most(2000)
      .or_else(S{}.around);
}

}  // namespace

void declare(config::Fields<TubeShape>& f) {
  length(f, "radius", &TubeShape::radius, "inner radius at the inlet");
  length(f, "length", &TubeShape::length, "length");
  optional_length(f, "outlet_radius", &TubeShape::outlet_radius,
                  "inner radius at the outlet; 0: like the inlet");
  sides(f);
}

void declare(config::Fields<BendShape>& f) {
  length(f, "radius", &BendShape::radius, "inner radius");
  length(f, "bend_radius", &BendShape::bend_radius, "radius of the centreline");
  angle(f, "angle", &BendShape::angle, "angle of the arc");
  length(f, "inlet_length", &BendShape::inlet_length, "straight part before the arc");
  length(f, "outlet_length", &BendShape::outlet_length, "straight part behind the arc");
  sides(f);
}

void declare(config::Fields<BifurcationShape>& f) {
  using S = BifurcationShape;
  length(f, "parent_radius", &S::parent_radius, "inner radius of the parent");
  length(f, "parent_length", &S::parent_length, "length of the parent");
  length(f, "daughter_radius", &S::daughter_radius, "inner radius of the daughters");
  optional_length(f, "second_daughter_radius", &S::second_daughter_radius,
                  "of the second daughter; 0: like the first");
  length(f, "daughter_length", &S::daughter_length, "length of the daughters");
  angle(f, "angle", &S::angle, "angle between the daughters");
  length(f, "fillet", &S::fillet, "rounding of the junction");
  optional_length(f, "edge", &S::edge, "edge of the triangles; 0: a quarter of the smallest radius");
}

void declare(config::Fields<ArchShape>& f) {
  using S = ArchShape;
  length(f, "ascending_radius", &S::ascending_radius, "inner radius of the ascending part");
  length(f, "descending_radius", &S::descending_radius, "inner radius of the descending part");
  length(f, "arch_radius", &S::arch_radius, "radius of the half circle");
  length(f, "ascending_length", &S::ascending_length, "length of the ascending part");
  length(f, "descending_length", &S::descending_length, "length of the descending part");
  f.list("branch_radii", &S::branch_radii, "m", "inner radii of the branches, from the inlet on")
      .positive()
      .or_else(S{}.branch_radii);
  length(f, "branch_length", &S::branch_length, "length of the branches beyond the wall of the arch");
  length(f, "fillet", &S::fillet, "rounding of the junctions");
  optional_length(f, "edge", &S::edge, "edge of the triangles; 0: a quarter of the smallest radius");
}

}  // namespace ostium::sph3d
