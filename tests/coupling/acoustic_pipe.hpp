/// A rigid pipe of compressible fluid in one dimension, the smallest vessel a network can be coupled to.
///
///   |-> Q_in   p_0 | u_1 | p_1 | u_2 | ...   p_{N-1} |-> Q_out, P
///
///   dp_i/dt = -(rho c^2/(A dx)) (Q_{i+1} - Q_i)        rho dx/A dQ_i/dt = p_{i-1} - p_i
///   rho dx/(2A) dQ_N/dt = p_{N-1} - P                  P: implicit port with the law the scheme gives
///
///   staggered, symplectic, 40 cells, Courant number 0.3, no damping of its own
///
/// With a datum, p is relative to it, and the law's pressure is lowered by it.
#pragma once
#include <cmath>
#include <functional>
#include <optional>

#include "coupling/scheme.hpp"
#include "sph3d/openings/port_law.hpp"
#include "sph3d/openings/pressure_datum.hpp"

namespace ostium::coupling {

struct PipeSetup {
  double rho = 1000, c = 10, length = 0.03175, area = 6.35e-3;
  std::function<double(double)> inflow = {};  // m3/s
  double end = 0.6;                           // s
  double window = 0;                          // s between exchanges; 0: every step
  std::optional<double> filter_time = {};     // with the complementary filter
  double bias = 1.0;                          // conjugate flow over true flow
  std::optional<sph3d::PressureDatum> datum = {};
  int cells = 40;
};

/// One row per exchange.
struct PipeSample {
  double time, pressure, mean_flow;  // s, Pa (physical), m3/s
};

class AcousticPipe {
 public:
  AcousticPipe(const PipeSetup& setup, network::Network& network, Scheme& scheme)
      : s_(setup),
        network_(network),
        scheme_(scheme),
        dx_(s_.length / s_.cells),
        q_(s_.cells + 1, s_.inflow(0)) {
    const double step = 0.3 * dx_ / s_.c;
    steps_ = std::max(1, static_cast<int>(std::ceil(s_.window / step)));
    dt_ = s_.window > 0 ? s_.window / steps_ : step;
    law_ = scheme_.start(network_, dt_ * steps_)[0];
    filter_ = sph3d::ComplementaryFilter::started_at(s_.bias * q_.back());
    filter_.q_counted = q_.back();
    pressure_ = network_.pressure(0);
    if (s_.datum) s_.datum->start(std::span(&pressure_, 1));
    p_.assign(s_.cells, pressure_ - reference());
  }

  /// Stops early where the pressure leaves all bounds. Returns one sample per exchange.
  std::vector<PipeSample> run(double bound = 1e9) {
    std::vector<PipeSample> samples;
    while (time_ < s_.end - 0.5 * dt_ && std::abs(pressure_) < bound) samples.push_back(exchange());
    return samples;
  }

 private:
  double reference() const { return s_.datum ? s_.datum->reference : 0.0; }

  PipeSample exchange() {
    double volume = 0;
    for (int i = 0; i < steps_; ++i) volume += step(i * dt_) * dt_;
    const double window = steps_ * dt_, mean = volume / window;
    if (s_.filter_time) filter_.step_counted(mean, window, *s_.filter_time);
    law_ = scheme_.exchange(network_, window, std::span(&mean, 1))[0];
    return {time_, pressure_, mean};
  }

  double step(double since_exchange) {
    const double inertia = s_.rho * dx_ / s_.area;
    q_[0] = s_.inflow(time_ + dt_);
    for (int i = 1; i < s_.cells; ++i) q_[i] += dt_ / inertia * (p_[i - 1] - p_[i]);
    drive_port(since_exchange + dt_, 2 * dt_ / inertia);
    for (int i = 0; i < s_.cells; ++i)
      p_[i] -= dt_ * s_.rho * s_.c * s_.c / (s_.area * dx_) * (q_[i + 1] - q_[i]);
    if (s_.datum) s_.datum->step(dt_, std::span(&pressure_, 1));
    time_ += dt_;
    return q_.back();
  }

  /// Everything the port knows is the conjugate flow, bias and all.
  void drive_port(double since_exchange, double beta_dt) {
    auto law = law_.at(since_exchange);
    if (s_.filter_time) law = filter_.corrected(law);
    if (s_.datum) law = s_.datum->relative(law);
    const double tilde = q_.back() + beta_dt * p_.back();
    const double P = sph3d::implicit_port_pressure(law, s_.bias * tilde, s_.bias * beta_dt);
    q_.back() = tilde - beta_dt * P;
    pressure_ = P + reference();
    if (s_.filter_time) filter_.step_conjugate(s_.bias * q_.back(), dt_, *s_.filter_time);
  }

  PipeSetup s_;
  network::Network& network_;
  Scheme& scheme_;
  double dx_, dt_ = 0, time_ = 0, pressure_ = 0;
  int steps_ = 1;
  std::vector<double> q_, p_;
  sph3d::PortLaw law_;
  sph3d::ComplementaryFilter filter_;
};

}  // namespace ostium::coupling
