/// Values and rates of the stages of one Runge-Kutta step: guesses, error, interpolation.
///
///   Y_i, K_i   unknowns and rates of stage i; K is 0 for algebraic unknowns
///   states between:     cubic through values and rates at both ends (Hermite)
///   algebraic between:  cubic through the values of four stages
///
/// Source: network/tableau; Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I (1993), sec. II.6.
/// Not checked: that the stages are solved.
#pragma once
#include <array>
#include <vector>

#include "network/system.hpp"
#include "network/tableau.hpp"

namespace ostium::network {

class Stages {
 public:
  Stages(const System& system, const Tableau& tableau);

  void start(const double* y, const double* dy);
  /// The end of this step becomes the begin of the next.
  void shift();
  /// A step of no length: the end is the begin.
  void stay();

  double* begin_values() { return values(0); }
  double* begin_rates() { return rates(0); }
  const double* begin_values() const { return values_.data(); }
  const double* begin_rates() const { return rates_.data(); }
  double* values(int i) { return values_.data() + static_cast<std::size_t>(i) * n_; }
  double* rates(int i) { return rates_.data() + static_cast<std::size_t>(i) * n_; }
  const double* base() const { return base_.data(); }

  /// What the stages before i say about it; sets base.
  void guess(int i, double h, double hg);
  /// Error of the states, as the embedded method gives it: at the index of each unknown.
  double* error(double h);
  /// Largest of them over tolerance (|y| + scale).
  double largest(const double* error, double tolerance) const;
  /// All unknowns at t_n + s h; the rates at the ends are those of the stages.
  void interpolate(double s, double* y) const;

 private:
  const System& system_;
  const Tableau& tableau_;
  std::size_t n_;
  std::vector<int> algebraic_;
  std::vector<double> values_, rates_, base_, error_;
  std::vector<std::array<double, 3>> weights_;  // of up to three stages before, for the guess
  std::vector<std::array<int, 3>> before_;
  double h_ = 0;
};

}  // namespace ostium::network
