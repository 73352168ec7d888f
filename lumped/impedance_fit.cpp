#include "lumped/impedance_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "lumped/nonnegative.hpp"

namespace ostium::lumped {
namespace {

using Complex = std::complex<double>;

/// A passive part of unit resistance; see the header.
struct Part {
  enum class Kind { resistance, capacitive, inductive, resonant, notch } kind;
  double tau, damping = 0;
  Complex operator()(double omega) const {
    const Complex s(0, omega * tau);
    const Complex band = damping * s / (1.0 + damping * s + s * s);
    switch (kind) {
      case Kind::resistance:
        return 1;
      case Kind::capacitive:
        return 1.0 / (1.0 + s);
      case Kind::inductive:
        return s / (1.0 + s);
      case Kind::resonant:
        return band;
      case Kind::notch:
        return 1.0 - band;
    }
    return 0;
  }
  int states() const { return kind == Kind::resistance ? 0 : damping > 0 ? 2 : 1; }
};

/// tau from the fastest to the slowest sample, some way further on both sides.
std::vector<Part> grid(const std::vector<ImpedanceSample>& samples) {
  double low = INFINITY, high = 0;
  for (const auto& s : samples)
    if (s.omega > 0) low = std::min(low, s.omega), high = std::max(high, s.omega);
  std::vector<Part> parts{{Part::Kind::resistance, 0}};
  constexpr int per_decade = 8;
  const double decades = std::log10(high / low) + 1.5;
  for (int k = 0; k <= static_cast<int>(per_decade * decades); ++k) {
    const double tau = 0.2 / high * std::pow(10.0, static_cast<double>(k) / per_decade);
    parts.push_back({Part::Kind::capacitive, tau}), parts.push_back({Part::Kind::inductive, tau});
    for (const double damping : {0.3, 0.7, 1.5})
      parts.push_back({Part::Kind::resonant, tau, damping}),
          parts.push_back({Part::Kind::notch, tau, damping});
  }
  return parts;
}

/// What the parts give to Z(0).
double at_rest(const std::vector<Part>& parts, const Eigen::VectorXd& x) {
  double sum = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) sum += x[k] * parts[k](0).real();
  return sum;
}

void make_exact_at_rest(const std::vector<Part>& parts, Eigen::VectorXd& x,
                        const std::vector<ImpedanceSample>& samples) {
  const double rest = at_rest(parts, x);
  if (samples.front().omega == 0 && rest > 0) x *= samples.front().Z.real() / rest;
}

constexpr double much = 30;

/// Weights of the parts by non-negative least squares of relative errors. Z(0) counts much and is then made exact.
Eigen::VectorXd weights(const std::vector<Part>& parts, const std::vector<ImpedanceSample>& samples) {
  Eigen::MatrixXd A(2 * samples.size(), parts.size());
  Eigen::VectorXd b(2 * samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const auto& [omega, Z] = samples[n];
    const double w = (omega == 0 ? much : 1) / std::abs(Z);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Complex z = parts[k](omega);
      A(2 * n, k) = w * z.real(), A(2 * n + 1, k) = w * z.imag();
    }
    b(2 * n) = w * Z.real(), b(2 * n + 1) = w * Z.imag();
  }
  Eigen::VectorXd x = nonnegative_least_squares(A, b);
  make_exact_at_rest(parts, x, samples);
  return x;
}

/// Root mean square of the relative errors; none where the parts cannot give Z(0).
double misfit(const std::vector<Part>& parts, const Eigen::VectorXd& x,
              const std::vector<ImpedanceSample>& samples) {
  double sum = 0;
  for (const auto& [omega, Z] : samples) {
    Complex made = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) made += x[k] * parts[k](omega);
    if (omega == 0 && std::abs(made - Z) > 1e-6 * std::abs(Z)) return INFINITY;
    sum += std::norm(made - Z) / std::norm(Z);
  }
  return std::sqrt(sum / samples.size());
}

/// Only parts that count; those of one kind that are near each other become one at their weighted mean.
std::vector<Part> joined(const std::vector<Part>& parts, const Eigen::VectorXd& x) {
  struct Group {
    Part part;
    double weight, logs;
  };
  std::vector<Group> groups;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (x[k] <= 1e-6 * x.sum()) continue;
    const auto near = [&](const Group& g) {
      return g.part.kind == parts[k].kind && g.part.damping == parts[k].damping &&
             (parts[k].tau == g.part.tau || parts[k].tau / g.part.tau < 1.3);
    };
    const auto at = std::find_if(groups.begin(), groups.end(), near);
    const double log = parts[k].tau > 0 ? std::log(parts[k].tau) : 0;
    if (at == groups.end())
      groups.push_back({parts[k], x[k], x[k] * log});
    else
      at->part.tau = std::exp((at->logs += x[k] * log) / (at->weight += x[k]));
  }
  std::vector<Part> made;
  for (const auto& g : groups) made.push_back(g.part);
  return made;
}

int states(const std::vector<Part>& parts) {
  int sum = 0;
  for (const auto& p : parts) sum += p.states();
  return sum;
}

/// Logarithms of all weights, then of all tau and dampings: free numbers for values that must stay positive.
Eigen::VectorXd logarithms(const std::vector<Part>& parts, const Eigen::VectorXd& x) {
  std::vector<double> all;
  for (const double weight : x) all.push_back(std::log(weight));
  for (const auto& p : parts) {
    if (p.tau > 0) all.push_back(std::log(p.tau));
    if (p.damping > 0) all.push_back(std::log(p.damping));
  }
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

void from_logarithms(const Eigen::VectorXd& all, std::vector<Part>& parts, Eigen::VectorXd& x) {
  Eigen::Index n = x.size();
  x = all.head(n).array().exp();
  for (auto& p : parts) {
    if (p.tau > 0) p.tau = std::exp(all[n++]);
    if (p.damping > 0) p.damping = std::exp(all[n++]);
  }
}

/// Weighted relative errors, real and imaginary parts.
Eigen::VectorXd errors(const std::vector<Part>& parts, const Eigen::VectorXd& x,
                       const std::vector<ImpedanceSample>& samples) {
  Eigen::VectorXd r(2 * static_cast<Eigen::Index>(samples.size()));
  Eigen::Index row = 0;
  for (const auto& [omega, Z] : samples) {
    Complex made = -Z;
    for (std::size_t k = 0; k < parts.size(); ++k) made += x[static_cast<Eigen::Index>(k)] * parts[k](omega);
    made *= (omega == 0 ? much : 1) / std::abs(Z);
    r[row++] = made.real(), r[row++] = made.imag();
  }
  return r;
}

/// Moves weights, tau and dampings to the least error nearby (Levenberg & Marquardt in their logarithms).
void refine(std::vector<Part>& parts, Eigen::VectorXd& x, const std::vector<ImpedanceSample>& samples) {
  const auto error = [&](const Eigen::VectorXd& all) {
    from_logarithms(all, parts, x);
    return errors(parts, x, samples);
  };
  Eigen::VectorXd at = logarithms(parts, x), r = error(at);
  double damping = 1e-3;
  for (int round = 0; round < 200 && damping < 1e8; ++round) {
    Eigen::MatrixXd J(r.size(), at.size());
    constexpr double h = 1e-6;
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      Eigen::VectorXd moved = at;
      moved[k] += h;
      J.col(k) = (error(moved) - r) / h;
    }
    Eigen::MatrixXd N = J.transpose() * J;
    N.diagonal() *= 1 + damping;
    N.diagonal().array() += 1e-12 * N.diagonal().maxCoeff();
    const Eigen::VectorXd step = N.ldlt().solve(-J.transpose() * r).cwiseMax(-0.5).cwiseMin(0.5);
    const Eigen::VectorXd trial = error(at + step);
    const double gain = 1 - trial.squaredNorm() / r.squaredNorm();
    damping *= gain > 0 ? 0.3 : 4;
    if (gain > 0) at += step, r = trial;
    if (gain > 0 && gain < 1e-6) break;
  }
  from_logarithms(at, parts, x);
  make_exact_at_rest(parts, x, samples);
}

/// Parts of weight 0 are none.
void drop_empty(std::vector<Part>& parts, Eigen::VectorXd& x) {
  std::vector<Part> kept;
  std::vector<double> weight;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (const double w = x[static_cast<Eigen::Index>(k)]; w > 0)
      kept.push_back(parts[k]), weight.push_back(w);
  parts = kept;
  x = Eigen::Map<Eigen::VectorXd>(weight.data(), static_cast<Eigen::Index>(weight.size()));
}

/// Drops the part whose loss costs least.
void drop_one(std::vector<Part>& parts, Eigen::VectorXd& x, const std::vector<ImpedanceSample>& samples) {
  double best = INFINITY;
  std::vector<Part> kept;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].tau == 0) continue;
    auto fewer = parts;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    const Eigen::VectorXd trial = weights(fewer, samples);
    if (const double m = misfit(fewer, trial, samples); m < best) best = m, kept = fewer, x = trial;
  }
  parts = kept;
}

}  // namespace

std::complex<double> RationalImpedance::operator()(double omega) const {
  Complex Z = D;
  for (const auto& [a, tau, damping] : terms) {
    const Complex s(0, omega * tau);
    Z += damping > 0 ? a * damping * s / (1.0 + damping * s + s * s) : a / (1.0 + s);
  }
  return Z;
}

RationalImpedance fit_impedance(const std::vector<ImpedanceSample>& samples, int most_states) {
  std::vector<Part> parts = grid(samples);
  Eigen::VectorXd x = weights(parts, samples);
  parts = joined(parts, x);
  x = weights(parts, samples);
  while (states(parts) > most_states) drop_one(parts, x, samples);
  drop_empty(parts, x);
  refine(parts, x, samples);
  RationalImpedance made;
  made.error = misfit(parts, x, samples);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto kind = parts[k].kind;
    if (kind == Part::Kind::resistance || kind == Part::Kind::inductive || kind == Part::Kind::notch)
      made.D += x[k];
    const double sign = kind == Part::Kind::inductive || kind == Part::Kind::notch ? -1 : 1;
    if (x[k] > 0 && parts[k].tau > 0) made.terms.push_back({sign * x[k], parts[k].tau, parts[k].damping});
  }
  return made;
}

}  // namespace ostium::lumped
