#include "network/closure.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "lumped/resistor.hpp"

namespace ostium::network {

namespace {

const std::string hub = "(openings)";
constexpr double R_star = 1e3;  // Pa.s/m3

std::string arm(const Port& port) { return "(to " + port.opening + ")"; }

bool fixes_pressure(const lumped::Block& block, const std::string& node) {
  for (const auto& b : block.branches()) {
    if (b.nature != lumped::Nature::capacitive && b.nature != lumped::Nature::pressure) continue;
    if (block.terminals()[b.a].node == node) return true;
    if (b.b != lumped::ground && block.terminals()[b.b].node == node) return true;
  }
  return false;
}

bool needs_star(const Model& model, const std::vector<Port>& ports) {
  std::set<std::string> fixed;
  for (const auto& port : ports)
    for (const auto& e : model.entries)
      if (fixes_pressure(*e.block, port.opening)) fixed.insert(port.opening);
  return fixed.size() > 1;
}

Model with_star(Model model, const std::vector<Port>& ports) {
  for (const auto& port : ports) {
    lumped::Resistor r;
    r.from = hub, r.to = port.opening, r.R = R_star;
    model.entries.push_back({arm(port), model.where, std::make_shared<lumped::BlockOf<lumped::Resistor>>(r)});
  }
  return model;
}

}  // namespace

Closure::Closure(const Model& model, const std::vector<Port>& ports)
    : ports_(ports),
      star_(needs_star(model, ports)),
      system_(star_ ? with_star(model, ports) : model, star_ ? std::vector<Port>{} : ports,
              Junction::merged) {}

int Closure::index_of(const std::string& series) const {
  const auto& names = system_.names();
  const auto at = std::find(names.begin(), names.end(), series);
  OSTIUM_ASSERT(at != names.end(), "no series {} in the closed network", series);
  return static_cast<int>(at - names.begin());
}

double Closure::flow(int port, double t, const double* y, const double* dy) const {
  if (star_) return y[index_of("q:" + arm(ports_[port]) + "_m3_s")];
  return system_.flow_through_opening(port, t, y, dy);
}

double Closure::pressure(const double* y) const {
  return ports_.empty() ? 0.0 : y[index_of("p:" + hub + "_Pa")];
}

}  // namespace ostium::network
