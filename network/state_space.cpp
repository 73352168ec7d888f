#include "network/state_space.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/MatrixFunctions>

#include "core/error.hpp"
#include "network/sparse_lu.hpp"

namespace ostium::network {

namespace {

struct Parts {
  Eigen::MatrixXd M, N;  // n x n, n x states; columns over scales, rows over their largest entry
  Eigen::VectorXd row_scale;
};

Parts parts(const System& s, double t, const double* y, const double* dy) {
  const auto& pattern = s.pattern();
  std::vector<double> d_y(pattern.nonZeros()), d_dy(pattern.nonZeros());
  s.jacobian(t, y, dy, d_y.data(), d_dy.data());
  const auto& states = s.differential_unknowns();
  Parts p{Eigen::MatrixXd::Zero(s.size(), s.size()), Eigen::MatrixXd::Zero(s.size(), states.size()), {}};
  const auto spread = [&](int j, const std::vector<double>& values, auto column) {
    for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k)
      column[pattern.innerIndexPtr()[k]] = values[k] * s.scale()[j];
  };
  for (int j = 0; j < s.size(); ++j) spread(j, s.differential(j) ? d_dy : d_y, p.M.col(j));
  for (size_t i = 0; i < states.size(); ++i) spread(states[i], d_y, p.N.col(i));
  p.row_scale = p.M.cwiseAbs().rowwise().maxCoeff().unaryExpr([](double r) { return r > 0 ? r : 1.0; });
  p.M.array().colwise() /= p.row_scale.array();
  p.N.array().colwise() /= p.row_scale.array();
  return p;
}

/// The block that owns the unknown, or the first one at the node.
const std::string& place_of(const System& s, int unknown) {
  const auto& entries = s.model().entries;
  const auto& nodes = s.graph().node_of;
  for (size_t i = 0; i < entries.size(); ++i) {
    const int behind = i + 1 < entries.size() ? s.own(static_cast<int>(i) + 1) : s.size();
    const bool own = unknown >= s.own(static_cast<int>(i)) && unknown < behind;
    if (own || std::count(nodes[i].begin(), nodes[i].end(), unknown)) return entries[i].where;
  }
  return s.model().where;
}

/// `open`: what the equations leave free, over scales.
[[noreturn]] void refuse_singular(const System& s, const Eigen::VectorXd& open) {
  constexpr int most = 8;
  std::string names;
  int count = 0, largest = 0;
  open.cwiseAbs().maxCoeff(&largest);
  for (int j = 0; j < s.size(); ++j)
    if (std::abs(open[j]) > 1e-3 * open.lpNorm<Eigen::Infinity>() && ++count <= most)
      names += (names.empty() ? "" : ", ") + s.names()[j];
  if (count > most) names += fmt::format(" and {} more", count - most);
  user_error(
      "{}: the blocks leave {} undetermined: their equations contradict or repeat each other; look for "
      "sources or stores "
      "that act on each other directly and put a resistor or a small compliance between them",
      place_of(s, largest), names);
}

/// E: a unit port flow enters at the row of its node.
Eigen::MatrixXd inputs(const System& s, const Eigen::VectorXd& row_scale) {
  const auto& node = s.graph().port_node;
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(s.size(), node.size());
  if (s.graph().junction == Junction::separate)
    for (size_t k = 0; k < node.size(); ++k)
      if (node[k] != outside) E(node[k], k) = 1 / row_scale[node[k]];
  return E;
}

template <class Matrix>
Eigen::MatrixXd state_rows(const System& s, const Matrix& m) {
  const auto& states = s.differential_unknowns();
  Eigen::MatrixXd rows(states.size(), m.cols());
  if (m.cols() == 0) return rows;  // nothing to point to
  for (size_t i = 0; i < states.size(); ++i) rows.row(i) = m.row(states[i]);
  return rows;
}

template <class Matrix>
Eigen::MatrixXd pressure_rows(const System& s, const Matrix& m) {
  const auto& node = s.graph().port_node;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(node.size(), m.cols());
  if (m.cols() == 0) return rows;
  for (size_t k = 0; k < node.size(); ++k)
    if (node[k] != outside) rows.row(k) = m.row(node[k]) * s.scale()[node[k]];
  return rows;
}

}  // namespace

namespace {

/// The matrix with those values on the system's pattern, rows over their largest entry.
Eigen::SparseMatrix<double> row_scaled(const System& s, const std::vector<double>& values) {
  Eigen::SparseMatrix<double> matrix = s.pattern();
  std::copy(values.begin(), values.end(), matrix.valuePtr());
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(s.size());
  for (int j = 0; j < s.size(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator k(matrix, j); k; ++k)
      largest[k.row()] = std::max(largest[k.row()], std::abs(k.value()));
  return largest.unaryExpr([](double r) { return r > 0 ? 1 / r : 1.0; }).asDiagonal() * matrix;
}

/// Inverse iteration beside the eigenvalue 0: where there is one, x tends to what the matrix M takes to nothing.
///   (M + delta I) x_{k+1} = x_k
void check_kernel(const System& s, const std::vector<double>& values) {
  constexpr double delta = 1e-9, nothing = 1e-13;
  const Eigen::SparseMatrix<double> matrix = row_scaled(s, values);
  Eigen::SparseMatrix<double> one(s.size(), s.size());
  one.setIdentity();
  Eigen::SparseMatrix<double> moved = matrix + delta * one;
  moved.makeCompressed();
  SparseLu lu(s.size(), moved.outerIndexPtr(), moved.innerIndexPtr());
  if (!lu.factor(moved.valuePtr())) return;  // who solves it says so
  Eigen::VectorXd x = Eigen::VectorXd::Ones(s.size());
  for (int k = 0; k < 5; ++k) {
    lu.solve({x.data(), static_cast<size_t>(x.size())});
    if (!(x.lpNorm<Eigen::Infinity>() > 0) || !x.allFinite()) return;
    x /= x.lpNorm<Eigen::Infinity>();
    if ((matrix * x).lpNorm<Eigen::Infinity>() < nothing) refuse_singular(s, x);
  }
}

}  // namespace

void check_index(const System& s) {
  const std::vector<double> zero(s.size(), 0.0);
  const Eigen::VectorXd start = s.start();
  const int *column = s.pattern().outerIndexPtr(), *row = s.pattern().innerIndexPtr();
  std::vector<double> d_y(s.pattern().nonZeros()), d_dy(d_y.size());
  s.jacobian(0, start.data(), zero.data(), d_y.data(), d_dy.data());
  for (int j = 0; j < s.size(); ++j)
    for (int k = column[j]; k < column[j + 1]; ++k)
      d_y[k] = (s.differential(j) ? d_dy[k] : d_y[k]) * s.scale()[j];
  constexpr double sound = 1e-12;
  SparseLu lu(s.size(), column, row);
  if (lu.factor(d_y.data()) && lu.pivot_ratio() > sound) return;
  constexpr int few = 300;  // full pivoting of more takes seconds
  if (s.size() > few) return check_kernel(s, d_y);
  linearise(s, 0, start.data(), zero.data());  // full pivoting decides, and names the unknowns
}

StateSpace linearise(const System& s, double t, const double* y, const double* dy) {
  const Parts p = parts(s, t, y, dy);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(p.M);
  lu.setThreshold(1e-13);
  if (!lu.isInvertible()) refuse_singular(s, lu.kernel().col(0));
  // No states, no ports: matrices without columns, which the solver is spared.
  const auto solved = [&](const Eigen::MatrixXd& m) { return m.cols() ? Eigen::MatrixXd(lu.solve(m)) : m; };
  const Eigen::MatrixXd x = -solved(p.N), q = solved(inputs(s, p.row_scale));
  return {state_rows(s, x), state_rows(s, q), pressure_rows(s, x), pressure_rows(s, q)};
}

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& m) {
  if (m.rows() == 0) return m;
  return m.exp();
}

std::array<Eigen::MatrixXd, 5> phi_functions(const Eigen::MatrixXd& m) {
  constexpr int terms = 14, last = 4;
  const auto n = m.rows();
  const double size = m.size() ? m.cwiseAbs().rowwise().sum().maxCoeff() : 0;
  const int squarings = size > 0.5 ? static_cast<int>(std::ceil(std::log2(size / 0.5))) : 0;
  const Eigen::MatrixXd z = std::ldexp(1.0, -squarings) * m, one = Eigen::MatrixXd::Identity(n, n);
  constexpr std::array inverse_factorial{1.0, 1.0, 1.0 / 2, 1.0 / 6, 1.0 / 24};
  std::array<Eigen::MatrixXd, 5> phi;
  phi[last] = one;  // sum z^j 4!/(j+4)! by Horner's rule, then over 4!
  for (int j = terms; j > 0; --j) phi[last] = one + z * phi[last] / (j + last);
  phi[last] *= inverse_factorial[last];
  for (int k = last; k-- > 0;) phi[k] = z * phi[k + 1] + inverse_factorial[k] * one;
  for (int i = 0; i < squarings; ++i) {
    auto twice = phi;
    for (int k = 0; k <= last; ++k) {
      twice[k] = phi[0] * phi[k];
      for (int j = 1; j <= k; ++j) twice[k] += inverse_factorial[k - j] * phi[j];
      twice[k] *= std::ldexp(1.0, -k);
    }
    phi = std::move(twice);
  }
  return phi;
}

Eigen::MatrixXd held_flow_response(const StateSpace& s, double dt) {
  const auto n = s.A.rows(), m = s.B.cols();
  if (n == 0 || m == 0) return s.D;
  Eigen::MatrixXd joined = Eigen::MatrixXd::Zero(n + m, n + m);
  joined.topLeftCorner(n, n) = s.A * dt;
  joined.topRightCorner(n, m) = s.B * dt;
  return s.D + s.C * matrix_exponential(joined).topRightCorner(n, m);
}

Eigen::MatrixXcd frequency_response(const StateSpace& s, double omega) {
  const std::complex<double> i(0, 1);
  const auto n = s.A.rows();
  Eigen::MatrixXcd z = s.D.cast<std::complex<double>>();
  if (n == 0 || s.B.cols() == 0) return z;
  const Eigen::MatrixXcd resolvent = i * omega * Eigen::MatrixXcd::Identity(n, n) - s.A;
  return z + s.C.cast<std::complex<double>>() * resolvent.fullPivLu().solve(s.B.cast<std::complex<double>>());
}

Eigen::MatrixXd transition(const StateSpace& s, double dt) { return matrix_exponential(s.A * dt); }

}  // namespace ostium::network
