/// What finding a periodic state cost, and how periodic it is.
#pragma once
#include <string>
#include <vector>

namespace ostium::network {

struct PeriodicReport {
  std::string method;          // "exact", "newton", "anderson"
  int cycle_integrations = 0;  // periods integrated, those with sensitivities included
  double change = 0;           // per cycle, before the last correction
  struct Residual {
    std::string state;  // name of the series
    double change;      // per cycle, SI
    double relative;    // over the scale of the state
  };
  std::vector<Residual> residuals{};
  int invariants = 0;  // conserved quantities: 1 for a closed loop
};

}  // namespace ostium::network
