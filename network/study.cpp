#include "network/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "network/shooting.hpp"

namespace ostium::network {

namespace {

constexpr NetworkOptions as_a_run{.relative_tolerance = SimulateOptions{}.relative_tolerance};

void check_period(const std::vector<Parameter>& parameters, const Model& model) {
  for (const auto& p : parameters)
    if (p.name.ends_with(".period"))
      user_error(
          "{}: {} is the period of a source, and a run from the periodic state keeps its period; start from "
          "rest (`network: {{initial: rest}}`) or leave it out",
          model.entries[p.entry].where, p.name);
}

/// begin + every, begin + 2 every, .. end
std::vector<double> row_times(double begin, double end, double every) {
  std::vector<double> times;
  for (long i = 1; begin + every * static_cast<double>(i) < end * (1 - 1e-9); ++i)
    times.push_back(begin + every * static_cast<double>(i));
  times.push_back(end);
  return times;
}

}  // namespace

Study::Study(const Model& model, std::vector<Parameter> parameters, const std::vector<Index>& indices,
             const StudyRun& run)
    : run_(run),
      parameters_(std::move(parameters)),
      indices_(indices),
      changes_(model),
      network_(model, {}, as_a_run),
      rows_(indices),
      y_(network_.series_names().size()) {
  const bool periodic = run.initial == Initial::periodic;
  const double window = run.period > 0 ? std::min(run.period, run.end) : run.end;
  if (periodic) {
    check_period(parameters_, model);
    orbit_.emplace(model, std::vector<Port>{}, run.period, network_.linear() ? as_a_run : NetworkOptions{});
  }
  network_.remember_sources();
  if (orbit_) orbit_->remember_sources();
  begins_ = periodic ? 0 : run.end - window;
  times_ = row_times(begins_, begins_ + window, run.every);
}

void Study::run(std::span<const double> values, std::span<double> results) {
  const auto blocks = changes_.blocks(parameters_, values);
  network_.replace(blocks);
  if (orbit_) {
    orbit_->replace(blocks);
    run_periodic();
  } else {
    network_.restart();
    if (begins_ > 0) network_.advance_to(begins_, {}, [](double, auto) {});
    window();
  }
  rows_.write(results);
  for (std::size_t i = 0; i < indices_.size(); ++i)
    if (!std::isfinite(results[i]))
      numerics_error("the result \"{}\" is {}, not a finite number", indices_[i].text, results[i]);
}

/// A linear network needs a single correction; that the results begin and end alike confirms it.
void Study::run_periodic() {
  constexpr double alike = 1e-5, enough = 1e-6;  // of the states' scales
  if (!network_.linear()) return from_periodic(enough);
  from_periodic(std::numeric_limits<double>::infinity());
  if (change() > alike) from_periodic(enough);
}

void Study::from_periodic(double enough) {
  find_periodic(*orbit_, enough);
  orbit_->begin();
  network_.load(orbit_->state());
  window();
}

void Study::window() {
  rows_.clear();
  network_.series(y_);
  rows_.add(network_.time(), y_);
  network_.advance_to(times_.back(), times_,
                      [this](double t, std::span<const double> y) { rows_.add(t, y); });
}

/// Largest change of a state over the period, over its scale.
double Study::change() const {
  const State end = network_.save();
  double most = 0;
  for (int i : orbit_->system().states())
    most = std::max(most, std::abs(end.y[i] - y_[i]) / orbit_->system().scale()[i]);
  return most;
}

}  // namespace ostium::network
