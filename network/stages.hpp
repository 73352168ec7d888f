/// Values and rates of the stages of one Runge-Kutta step: guesses, error, interpolation.
///
///   Y_i, K_i   unknowns and rates of stage i; K is 0 for algebraic unknowns
///   states between:     cubic through values and rates at both ends (Hermite)
///   algebraic between:  cubic through the values of four stages, or as in one more stage on the states' cubic
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

  /// A first step from here: nothing is known of what came before.
  void start(const double* y, const double* dy);
  /// The end of this step becomes the begin of the next, which goes on smoothly from it.
  void shift();
  /// It does not go on smoothly.
  void forget() { last_h_ = 0; }
  /// A step of no length: the end is the begin.
  void stay();

  const Tableau& tableau() const { return tableau_; }
  double* begin_values() { return values(0); }
  double* begin_rates() { return rates(0); }
  const double* begin_values() const { return values_.data(); }
  const double* begin_rates() const { return rates_.data(); }
  double* values(int i) { return values_.data() + static_cast<std::size_t>(i) * n_; }
  double* rates(int i) { return rates_.data() + static_cast<std::size_t>(i) * n_; }
  const double* base() const { return base_.data(); }

  /// A step of length h: where the stages stand that say something about the next one.
  void begin_step(double h);
  /// What the stages before i say about it, those of the step before included; sets base.
  void guess(int i, double h, double hg);
  /// Error of the states, as the embedded method gives it: at the index of each unknown.
  double* error(double h);
  /// Largest of them over tolerance (|y| + scale).
  double largest(const double* error, double tolerance) const;
  /// By how much a stage misses the polynomial through the others, over |y| + scale: what interpolation may be wrong by.
  double gap() const;
  /// All unknowns at t_n + s h; the rates at the ends are those of the stages.
  void interpolate(double s, double* y) const;
  /// The same as a guess of one more stage, at t_n + s h, through the states' cubic; sets base.
  void guess_between(double s, double hg, double* y, double* dy);

 private:
  /// Of three stages that lie before stage i in the order of their solution; those of the step before follow on the others.
  struct Guess {
    std::array<int, 3> stage{};
    std::array<double, 3> weight{};
  };
  Guess guess_from_before(int i) const;

  const System& system_;
  const Tableau& tableau_;
  std::size_t n_;
  std::vector<double> values_, rates_;  // of the stages, then of two of the step before
  std::vector<double> base_, error_;
  std::array<Guess, Tableau::most> guesses_{};
  struct Gap {
    std::array<int, 4> stage{};
    std::array<double, 4> weight{};
  } gap_;
  double h_ = 0, last_h_ = 0;  // of this step, of the one before; 0: it does not count
};

}  // namespace ostium::network
