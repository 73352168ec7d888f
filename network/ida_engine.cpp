#include <idas/idas.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "network/engine.hpp"
#include "network/ida_jacobian.hpp"

namespace ostium::network {

namespace {

class IdaEngine final : public Engine {
 public:
  IdaEngine(const System& system, Consistent& consistent, double relative_tolerance)
      : system_(system), consistent_(consistent), jacobian_(system) {
    check(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
    y_ = N_VNew_Serial(system.size(), context_);
    dy_ = N_VNew_Serial(system.size(), context_);
    kinds_ = N_VNew_Serial(system.size(), context_);
    row_ = N_VNew_Serial(system.size(), context_);
    tolerance_ = N_VNew_Serial(system.size(), context_);
    for (int i = 0; i < system.size(); ++i) {
      data(kinds_)[i] = system.differential(i) ? 1 : 0;
      data(tolerance_)[i] = relative_tolerance * system.scale()[i];
    }
    open(relative_tolerance);
  }
  IdaEngine(const IdaEngine&) = delete;
  IdaEngine& operator=(const IdaEngine&) = delete;
  ~IdaEngine() override {
    IDAFree(&ida_);
    SUNLinSolFree(solver_);
    SUNMatDestroy(matrix_);
    for (N_Vector v : {y_, dy_, row_, kinds_, tolerance_}) N_VDestroy(v);
    SUNContext_Free(&context_);
  }

  bool dense() const override { return true; }

  void advance(double a, double b, const Flows& flows, double* y, double* dy, Rows* rows) override {
    flows_ = &flows, rows_ = rows;
    const int n = system_.size();
    std::copy(y, y + n, data(y_));
    std::copy(dy, dy + n, data(dy_));
    for (int events = 0; a < b; ++events) {
      a = to_event(a, b);
      if (a < b) throw_switches(a, events);
    }
    consistent_.settle(b, flows.at(b), data(y_), data(dy_));
    std::copy(data(y_), data(y_) + n, y);
    std::copy(data(dy_), data(dy_) + n, dy);
    for (; rows && rows->due(b); ++rows->next) rows->take(rows->times[rows->next], y);
  }

 private:
  /// Integrates from a to b or to the first event before it; returns the time reached. Where an equation turns within
  /// less than a step (a steep smooth valve), IDA's test of convergence may accept algebraic unknowns that are not
  /// solved, and then no step is small enough: from consistent values at order 1 it goes on.
  double to_event(double a, double b) {
    for (int failures = 0;; ++failures) {
      // so close to the end a step would be of the size of round-off
      if (b - a < 1e-13 * (std::abs(a) + std::abs(b))) return b;
      start(a, b);
      double reached = a;
      const int flag = solve(b, reached);
      if (flag >= 0) return flag == IDA_ROOT_RETURN ? reached : b;
      if (flag != IDA_CONV_FAIL || reached == a || failures == most_failures) give_up(flag, reached);
      consistent_.settle(reached, flows_->at(reached), data(y_), data(dy_));
      a = reached;
    }
  }

  /// To b or the first event; the rows on the way are taken from IDA's interpolant.
  int solve(double b, double& reached) {
    if (!rows_) return IDASolve(ida_, b, &reached, y_, dy_, IDA_NORMAL);
    for (;;) {
      const int flag = IDASolve(ida_, b, &reached, y_, dy_, IDA_ONE_STEP);
      if (flag < 0) return flag;
      for (; rows_->due(reached) && rows_->times[rows_->next] < b; ++rows_->next) {
        check(IDAGetDky(ida_, rows_->times[rows_->next], 0, row_), "IDAGetDky");
        rows_->take(rows_->times[rows_->next], data(row_));
      }
      if (flag == IDA_ROOT_RETURN || flag == IDA_TSTOP_RETURN || reached >= b) return flag;
    }
  }

  void start(double a, double b) {
    check(IDAReInit(ida_, a, y_, dy_), "IDAReInit");
    // pivots of earlier intervals forgotten: a restart has the same bits as a run that goes on
    check(SUNLinSol_KLUReInit(solver_, matrix_, system_.pattern().nonZeros(), SUNKLU_REINIT_PARTIAL),
          "KLUReInit");
    set_directions();
    check(IDASetStopTime(ida_, b), "IDASetStopTime");
  }

  /// A switch that is on goes off where its guard falls through zero, and the other way round.
  void set_directions() {
    const int n = system_.switch_count();
    if (n == 0) return;
    std::vector<int> direction(n);
    for (int k = 0; k < n; ++k) direction[k] = system_.on(k, data(y_)) ? -1 : 1;
    check(IDASetRootDirection(ida_, direction.data()), "IDASetRootDirection");
  }

  void throw_switches(double t, int events) {
    std::vector<int> found(system_.switch_count());
    check(IDAGetRootInfo(ida_, found.data()), "IDAGetRootInfo");
    for (int k = 0; k < system_.switch_count(); ++k)
      if (found[k] != 0) {
        if (events > 10000) refuse_endless_switching(system_, t, k);
        system_.throw_switch(k, data(y_));
      }
    for (int& f : found) f = f != 0;
    consistent_.settle(t, flows_->at(t), data(y_), data(dy_), found);
  }

  static double* data(N_Vector v) { return N_VGetArrayPointer(v); }

  void open(double relative_tolerance) {
    ida_ = IDACreate(context_);
    check(IDAInit(ida_, residual, 0.0, y_, dy_), "IDAInit");
    check(IDASVtolerances(ida_, relative_tolerance, tolerance_), "IDASVtolerances");
    check(IDASetId(ida_, kinds_), "IDASetId");
    check(IDASetSuppressAlg(ida_, SUNTRUE), "IDASetSuppressAlg");
    check(IDASetUserData(ida_, this), "IDASetUserData");
    check(IDASetMaxNumSteps(ida_, 200000), "IDASetMaxNumSteps");
    check(IDASetErrFile(ida_, nullptr), "IDASetErrFile");
    matrix_ = jacobian_.matrix(context_);
    solver_ = SUNLinSol_KLU(y_, matrix_, context_);
    check(IDASetLinearSolver(ida_, solver_, matrix_), "IDASetLinearSolver");
    check(IDASetJacFn(ida_, jacobian), "IDASetJacFn");
    if (system_.switch_count() > 0) {
      check(IDARootInit(ida_, system_.switch_count(), guards), "IDARootInit");
      check(IDASetNoInactiveRootWarn(ida_), "IDASetNoInactiveRootWarn");
    }
  }

  static int residual(double t, N_Vector y, N_Vector dy, N_Vector f, void* user) {
    auto& self = *static_cast<IdaEngine*>(user);
    self.system_.residual(t, data(y), data(dy), self.flows_->at(t), data(f));
    return 0;
  }

  static int guards(double t, N_Vector y, N_Vector dy, double* g, void* user) {
    guards_to_cross(static_cast<IdaEngine*>(user)->system_, t, data(y), data(dy), g);
    return 0;
  }

  static int jacobian(double t, double cj, N_Vector y, N_Vector dy, N_Vector, SUNMatrix J, void* user,
                      N_Vector, N_Vector, N_Vector) {
    static_cast<IdaEngine*>(user)->jacobian_.write(t, data(y), data(dy), cj, J);
    return 0;
  }

  static void check(int flag, const char* call) { OSTIUM_ASSERT(flag >= 0, "{} returned {}", call, flag); }

  [[noreturn]] void give_up(int flag, double reached) const {
    long steps = 0;
    double step = 0;
    IDAGetNumSteps(ida_, &steps);
    IDAGetLastStep(ida_, &step);
    char* reason = IDAGetReturnFlagName(flag);
    const std::string name = reason;
    free(reason);
    numerics_error(
        "the network stopped at t = {:.9g} s after {} steps, the last one of {:.3g} s ({}); {} holds the "
        "worst "
        "residual: look at the blocks there for parameters that are off by orders of magnitude",
        reached, steps, step, name, worst_equation(system_, reached, *flows_, data(y_), data(dy_)));
  }

  static constexpr int most_failures = 1000;

  const System& system_;
  Consistent& consistent_;
  const Flows* flows_ = nullptr;
  Rows* rows_ = nullptr;
  IdaJacobian jacobian_;
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr, dy_ = nullptr, row_ = nullptr, kinds_ = nullptr, tolerance_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  void* ida_ = nullptr;
};

}  // namespace

std::unique_ptr<Engine> make_ida_engine(const System& system, Consistent& consistent,
                                        double relative_tolerance) {
  return std::make_unique<IdaEngine>(system, consistent, relative_tolerance);
}

}  // namespace ostium::network
