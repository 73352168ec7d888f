/// Results that follow from the series of a run's last complete cycle: what a physiologist reads off them.
///
///   pressures    of each node and opening: systolic (largest), diastolic (least), mean (MAP), pulse = systolic - diastolic
///   chambers     end-diastolic and end-systolic volume EDV = max V, ESV = min V; stroke volume SV = EDV - ESV; ejection
///                fraction EF = SV/EDV; cardiac output: mean flow that leaves its node through blocks that begin there;
///                stroke work W = -oint p dV, the area of the pressure-volume loop
///   sources      of each flow source: cardiac output (mean flow), stroke volume = mean flow times period
///   flow_splits  of each node where blood divides: share of each block in the mean flow that leaves the node
///   outlets      of each opening, or of each block that ends at a fixed pressure: mean flow, share in all outflow
///
///   pressures mmHg, volumes mL, cardiac output L/min, flows mL/s, W J, EF and shares 1
///
/// As fine as the rows the statistics see: `output.every` of a network alone, every exchange with a vessel. W sums
/// trapezoids. Not checked: that the cycle is periodic (`periodicity` of the summary says how far it is).
#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/results/cycles.hpp"
#include "network/model.hpp"

namespace ostium::app {

/// A block as the derived results see it.
struct Element {
  std::string name, type, from, to;  // nodes; empty: a ground
};
std::vector<Element> elements_of(const network::Model& model);

/// Sums per cycle of increments between two rows; an increment across the end of a cycle is shared by time.
class CycleSums {
 public:
  explicit CycleSums(double period = 0) : period_(period) {}
  void add(double from, double to, double increment);
  double last_complete(double reached) const;
  void archive(Archive& a);

 private:
  double period_;
  std::vector<double> sums_;
};

/// What a resumed run needs of the sitting before.
struct DerivedState {
  double time = 0;
  std::vector<double> last{};  // series of the row before
  std::vector<CycleSums> work{};
};
void archive(Archive& a, DerivedState& state);

class Derived {
 public:
  /// The last complete cycle of a series by its name; nothing where there is no such series.
  using Lookup = std::function<std::optional<CycleValues>(const std::string& series)>;

  Derived(std::vector<Element> elements, std::vector<std::string> ports,
          const std::vector<std::string>& series, double period);
  void row(double time, std::span<const double> series);
  nlohmann::json results(const Lookup& cycle) const;
  const DerivedState& save() const { return state_; }
  void recall(const DerivedState& state);

 private:
  struct Loop {
    int element;
    std::size_t pressure, volume;  // series
  };
  nlohmann::json pressures(const Lookup& cycle) const;
  nlohmann::json chambers(const Lookup& cycle) const;
  nlohmann::json sources(const Lookup& cycle) const;
  nlohmann::json flow_splits(const Lookup& cycle) const;
  nlohmann::json outlets(const Lookup& cycle) const;
  double leaving(const std::string& node, int element, const Lookup& cycle) const;

  std::vector<Element> elements_;
  std::vector<std::string> ports_, nodes_;
  std::vector<Loop> loops_;
  double period_;
  DerivedState state_;  // work per loop in J
};

}  // namespace ostium::app
