#include "network/sensitivities.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "network/shooting.hpp"

namespace ostium::network {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<Nearby> all_nearby(const System& system, const std::vector<Parameter>& parameters) {
  std::vector<Nearby> all;
  for (const auto& p : parameters) all.push_back(nearby(system, p));
  return all;
}

void check_period(const std::vector<Parameter>& parameters, const Model& model) {
  for (const auto& p : parameters)
    if (p.name.ends_with(".period"))
      user_error(
          "{}: {} is the period of a source; a periodic state has no derivative with respect to it, start "
          "from rest or "
          "leave it out",
          model.entries[p.entry].where, p.name);
}

/// Which of a family of periodic states follows a change of a parameter is known where all that is conserved is linear.
void check_conserved(const Orbit& orbit, const MatrixXd& M, const MatrixXd& c) {
  const MatrixXd more = further_invariants(M, c);
  if (more.rows() == 0) return;
  int at = 0;
  more.row(0).cwiseAbs().maxCoeff(&at);
  const auto& system = orbit.system();
  user_error(
      "{}: the network keeps something that is not linear in its states, {} among them, as a sphere_chamber "
      "keeps its "
      "volume at a radius; derivatives of its periodic state are not known, ask for those of a start from "
      "rest "
      "(`network: {{initial: rest}}`) over enough cycles",
      system.model().where, system.names()[system.states()[at]]);
}

/// Where the window of the indices begins, and the state and sensitivities there.
struct Begin {
  State state;
  MatrixXd S;
};

Begin from_rest(const System& system, Consistent& consistent, Tangent& tangent, double until) {
  const auto y = system.start();
  Begin b{{0, {y.begin(), y.end()}, std::vector<double>(y.size(), 0.0), {}}, tangent.start()};
  if (until > 0) TangentEngine(system, consistent, tangent).march(until, b.state, b.S);
  return b;
}

/// dc/dp^T v for every invariant (rows) and parameter (columns): v on all unknowns, SI.
MatrixXd moved_invariants(const Orbit& orbit, const Invariants& invariants, Eigen::Index count,
                          const std::vector<Nearby>& near, const VectorXd& v) {
  const auto& s = orbit.state();
  MatrixXd moved(count, near.size());
  const std::vector<double> zero(v.size(), 0.0);
  for (size_t p = 0; p < near.size(); ++p) {
    VectorXd f = VectorXd::Zero(v.size());
    const auto add = [&](const lumped::Block& block, double weight) {
      orbit.system().add_residual(near[p].entry, block, weight, s.time, s.y.data(), v.data(), f.data());
      orbit.system().add_residual(near[p].entry, block, -weight, s.time, s.y.data(), zero.data(), f.data());
    };
    add(*near[p].above, near[p].weight), add(*near[p].below, -near[p].weight);
    moved.col(p) = invariants.combined(f);
  }
  return moved;
}

Begin from_periodic(Orbit& orbit, const std::vector<Nearby>& near, const MatrixXd& start) {
  const auto& system = orbit.system();
  const VectorXd given = system.start();
  find_periodic(orbit);
  const VectorXd x = orbit.states();
  const State at_start = orbit.state();
  const auto l = orbit.linearised(x, near);
  orbit.set(x);
  const MatrixXd c = orbit.invariants().rows();
  check_conserved(orbit, l.M, c);
  VectorXd apart = VectorXd::Zero(system.size());
  MatrixXd start_rows(x.size(), near.size());
  for (int i = 0; i < x.size(); ++i) {
    const int j = system.states()[i];
    apart[j] = given[j] - x[i] * system.scale()[j];
    start_rows.row(i) = start.row(j) / system.scale()[j];
  }
  const MatrixXd conserved =
      c * start_rows + moved_invariants(orbit, orbit.invariants(), c.rows(), near, apart);
  const MatrixXd s = bordered(orbit, l.M, c, l.P, conserved);
  Begin b{at_start, MatrixXd::Zero(system.size(), near.size())};
  for (int i = 0; i < x.size(); ++i) {
    const int j = system.states()[i];
    b.state.y[j] = x[i] * system.scale()[j];
    b.S.row(j) = s.row(i) * system.scale()[j];
  }
  b.state.time = 0;
  return b;
}

}  // namespace

Sensitivities sensitivities(const Model& model, const std::vector<Index>& indices,
                            const std::vector<Parameter>& parameters, const SensitivityRun& run) {
  const bool periodic = run.initial == Initial::periodic;
  if (periodic) check_period(parameters, model);
  const System system(model, {});
  const auto near = all_nearby(system, parameters);
  Consistent consistent(system);
  Tangent tangent(system, 0, near);
  const double window = run.period > 0 ? std::min(run.period, run.end) : run.end;
  const double begins = periodic ? 0 : run.end - window;
  Begin b;
  if (periodic) {
    Orbit orbit(model, {}, run.period);
    b = from_periodic(orbit, near, tangent.start());
  } else {
    b = from_rest(system, consistent, tangent, begins);
  }
  IndexWatcher watcher(indices, tangent.count());
  TangentEngine(system, consistent, tangent).march(begins + window, b.state, b.S, &watcher);
  Sensitivities result{{}, MatrixXd(indices.size(), parameters.size())};
  for (size_t i = 0; i < indices.size(); ++i) {
    const Graded graded = watcher.value(indices[i]);
    result.values.push_back(graded.value);
    for (size_t p = 0; p < parameters.size(); ++p)
      result.gradients(i, p) = graded.gradient[p] / parameters[p].size;
  }
  return result;
}

}  // namespace ostium::network
