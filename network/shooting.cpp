#include "network/shooting.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace ostium::network {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// above: a period with that many sensitivities, or the exponential of a matrix of that size, costs more than ten without
constexpr int many_states = 60, many_states_linear = 300;

[[noreturn]] void refuse(const Orbit& orbit, const VectorXd& mode) {
  int at = 0;
  mode.cwiseAbs().maxCoeff(&at);
  const auto& system = orbit.system();
  user_error(
      "{}: the network has no periodic state of its own: nothing brings {} back to one value; give it a "
      "way out, for example a resistor to a ground, or start from rest",
      system.model().where, system.names()[system.states()[at]]);
}

[[noreturn]] void refuse_not_found(const Orbit& orbit, double change) {
  numerics_error(
      "no periodic state of period {} s was found after {} periods (it still changes by {:.2g} of 100 mmHg, "
      "100 mL/s, "
      "100 mL per period); check that every source has this period, or start from rest",
      orbit.period(), orbit.cycle_integrations(), change);
}

double size(const VectorXd& v) { return v.size() ? v.lpNorm<Eigen::Infinity>() : 0.0; }

PeriodicReport report(const Orbit& orbit, const char* method, const VectorXd& miss) {
  PeriodicReport r{.method = method, .cycle_integrations = orbit.cycle_integrations(), .change = size(miss)};
  const auto& system = orbit.system();
  for (int i = 0; i < miss.size(); ++i) {
    const int state = system.states()[i];
    r.residuals.push_back({system.names()[state], miss[i] * system.scale()[state], miss[i]});
  }
  return r;
}

/// What sources add to something conserved in a period cannot go anywhere.
void check_sources(const Orbit& orbit, const MatrixXd& c, const VectorXd& miss, double allowed) {
  for (int i = 0; i < c.rows(); ++i)
    if (std::abs(c.row(i).dot(miss)) > allowed) refuse(orbit, c.row(i).transpose());
}

/// Nothing where the integrator gives up and there is a way back.
std::optional<Orbit::Linearised> attempt(Orbit& orbit, const VectorXd& x, bool way_back) {
  try {
    return orbit.linearised(x);
  } catch (const NumericsError&) {
    if (!way_back) throw;
    return std::nullopt;
  }
}

PeriodicReport newton(Orbit& orbit, const char* method, double enough) {
  constexpr int most = 40, most_plain = 10;
  constexpr double near = 0.1;  // what is not linear is kept by a period, but not by a long step
  VectorXd x = orbit.states(), step;
  double last = INFINITY;
  int plain = 0;
  while (orbit.cycle_integrations() < most) {
    const auto l = attempt(orbit, x, step.size() > 0);
    const VectorXd miss = l ? VectorXd(l->end - x) : VectorXd();
    const double change = l ? size(miss) : INFINITY;
    if (!(change <= 2 * last)) {  // too far: half the way back
      step *= 0.5, x -= step;
      continue;
    }
    MatrixXd c = orbit.invariants().rows();
    check_sources(orbit, c, miss, 1e-6);
    if (const MatrixXd more = further_invariants(l->M, c); more.rows() > 0) {
      if (change > near && plain++ < most_plain) {
        x = l->end, step.resize(0), last = INFINITY;
        continue;
      }
      check_sources(orbit, more, miss, std::max(1e-6, 10 * change * change));  // curved: to first order only
      c.conservativeResize(c.rows() + more.rows(), c.cols());
      c.bottomRows(more.rows()) = more;
    }
    step = bordered(orbit, l->M, c, miss, MatrixXd::Zero(c.rows(), 1));
    x += step;
    last = change;
    if (change > enough) continue;
    orbit.set(x);
    auto r = report(orbit, method, miss);
    r.invariants = static_cast<int>(c.rows());
    return r;
  }
  refuse_not_found(orbit, last);
}

/// The last iterates' residuals as columns of differences: least squares for the mixture.
PeriodicReport anderson(Orbit& orbit, double enough) {
  constexpr int most = 200, depth = 12;
  VectorXd x = orbit.states(), last_end, last_miss, miss;
  MatrixXd dF(x.size(), 0), dG(x.size(), 0);
  const auto push = [](MatrixXd& m, const VectorXd& v) {
    MatrixXd next(v.size(), std::min<Eigen::Index>(m.cols() + 1, depth));
    next.leftCols(next.cols() - 1) = m.rightCols(next.cols() - 1);
    next.rightCols(1) = v;
    m = std::move(next);
  };
  while (orbit.cycle_integrations() < most) {
    const VectorXd end = orbit.after_period(x);
    miss = end - x;
    if (!miss.allFinite()) break;
    if (last_miss.size()) push(dF, miss - last_miss), push(dG, end - last_end);
    last_miss = miss, last_end = end;
    x = end;
    if (dF.cols() > 0) x -= dG * dF.colPivHouseholderQr().solve(miss);
    if (size(miss) > enough) continue;
    orbit.set(x);
    return report(orbit, "anderson", miss);
  }
  refuse_not_found(orbit, size(miss));
}

}  // namespace

MatrixXd further_invariants(const MatrixXd& M, const MatrixXd& c) {
  const auto n = M.rows();
  if (n == 0) return MatrixXd(0, 0);
  MatrixXd joined(n, n + c.rows());
  joined << MatrixXd::Identity(n, n) - M, c.transpose();
  const Eigen::JacobiSVD<MatrixXd> svd(joined, Eigen::ComputeFullU);
  const auto kept = (svd.singularValues().array() < 1e-6).count();
  return svd.matrixU().rightCols(kept).transpose();
}

MatrixXd bordered(const Orbit& orbit, const MatrixXd& M, const MatrixXd& c, const MatrixXd& r,
                  const MatrixXd& given) {
  const auto n = M.rows(), k = c.rows();
  if (n == 0) return MatrixXd(0, r.cols());
  MatrixXd A = MatrixXd::Zero(n + k, n + k), b(n + k, r.cols());
  A.topLeftCorner(n, n) = MatrixXd::Identity(n, n) - M;
  A.topRightCorner(n, k) = c.transpose(), A.bottomLeftCorner(k, n) = c;
  b << r, given;
  Eigen::FullPivLU<MatrixXd> lu(A);
  lu.setThreshold(1e-12);
  if (!lu.isInvertible()) refuse(orbit, lu.kernel().col(0).head(n));
  return lu.solve(b).topRows(n);
}

PeriodicReport find_periodic(Orbit& orbit, double enough) {
  const int n = static_cast<int>(orbit.system().states().size());
  if (n == 0) return {.method = "exact"};
  const bool linear = orbit.system().linear();
  if (n > (linear ? many_states_linear : many_states)) return anderson(orbit, enough);
  return newton(orbit, linear ? "exact" : "newton", enough);
}

}  // namespace ostium::network
