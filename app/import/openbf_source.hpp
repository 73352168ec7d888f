/// A network of openBF as its YAML has it: vessels between numbered nodes, an inflow, and what ends the last ones.
///
///   P = Pext + beta (sqrt(A/A0) - 1),   beta = E h0/(R0 (1 - 1/4))      wall, Poisson's ratio 1/2
///   friction 2 (gamma + 2) pi mu u per length                          velocity profile of power gamma
///   h0, where it is missing: R0 (0.2802 e^(-505.3 R0) + 0.1324 e^(-11.14 R0)), R0 in m
///
///   L, Rp, Rd   m     length, radius at begin and end, linear between; R0 for both
///   E, h0       Pa, m   stiffness and thickness of the wall
///   Pext        Pa    pressure at which the radius is that of the file
///   R1, R2, Cc  Pa.s/m3, m3/Pa   Windkessel; without R2 (two elements) R1 is all of it
///   Rt          1     reflection coefficient
///
/// Source: openBF's documentation (INSIGNEO); Boileau et al., Int. J. Numer. Meth. Biomed. Engng. 31 (2015) e02732. All in
/// SI. Checked: keys, ranges, that there is one inlet. Not checked: that a radius fits its neighbours.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/config.hpp"

namespace ostium::app::openbf {

struct BloodData {
  double rho = 0, mu = 0;
};

struct VesselData {
  std::string label;
  int sn = 0, tn = 0;  // begins and ends at these nodes
  double L = 0, E = 0, Pext = 0, gamma_profile = 2;
  std::optional<double> R0, Rp, Rd, h0, R1, R2, Cc, Rt;
  bool impedance_matching = false, visco_elastic = false;
  std::optional<config::Node> ignored;  // what steers its numerics and output
  config::Node origin;

  double begin_radius() const { return Rp ? *Rp : *R0; }
  double end_radius() const { return Rd ? *Rd : begin_radius(); }
};

struct Source {
  std::string name;
  BloodData blood;
  std::vector<VesselData> vessels;
  std::vector<double> times, flow;  // s, m3/s
  int inlet = 0;                    // node
  double period() const { return times.back(); }
};

void declare(config::Fields<BloodData>& f);
void declare(config::Fields<VesselData>& f);

/// Throws UserError with file, line and column.
Source read_source(const config::Node& root, std::vector<std::string>& notes);

}  // namespace ostium::app::openbf
