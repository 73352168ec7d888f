/// The network closed on itself where the vessel was, for its periodic state.
///
///   ideal junction   all openings are one node
///   star             each opening is joined to a common node by R_star = 1e3 Pa.s/m3 (0.1 Pa at 100 mL/s),
///                    where two openings fix their pressures by themselves (capacitors) and cannot be one node
///
/// Source: Kirchhoff's laws; a rigid vessel without losses. Not checked: that the vessel's own losses are small.
#pragma once
#include <string>
#include <vector>

#include "network/parameters.hpp"
#include "network/system.hpp"

namespace ostium::network {

class Closure {
 public:
  /// model: with its velocity sources placed.
  Closure(const Model& model, const std::vector<Port>& ports);

  const System& system() const { return system_; }
  void remember_sources() { system_.remember_sources(); }
  void replace(const Replacement& r) { system_.replace(r.entry, r.block); }
  /// Flow out of the vessel through the opening, m3/s.
  double flow(int port, double t, const double* y, const double* dy) const;
  /// Pa, common to all openings; 0 without openings.
  double pressure(const double* y) const;

 private:
  int index_of(const std::string& series) const;
  std::vector<Port> ports_;
  bool star_;
  System system_;
};

}  // namespace ostium::network
