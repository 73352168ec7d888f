#include "network/tangent_engine.hpp"

#include <idas/idas.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "network/ida_jacobian.hpp"
#include "network/march.hpp"

namespace ostium::network {

namespace {

constexpr double tolerance = 1e-8;              // of the trajectory, as network/engine
constexpr double sensitivity_tolerance = 1e-6;  // of the sensitivities

void check(int flag, const char* call) { OSTIUM_ASSERT(flag >= 0, "{} returned {}", call, flag); }
double* data(N_Vector v) { return N_VGetArrayPointer(v); }

}  // namespace

class TangentEngine::Ida final : public Interpolant {
 public:
  Ida(const System& system, Consistent& consistent, Tangent& tangent)
      : system_(system),
        consistent_(consistent),
        tangent_(tangent),
        flow_(system.ports().size(), 0.0),
        jacobian_(system),
        value_(system.size()),
        S_(Eigen::MatrixXd::Zero(system.size(), tangent.count())),
        dS_(S_) {
    check(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
    for (N_Vector* v : {&y_, &dy_, &kinds_, &absolute_, &work_}) *v = N_VNew_Serial(system.size(), context_);
    for (int i = 0; i < system.size(); ++i) {
      data(kinds_)[i] = system.differential(i) ? 1 : 0;
      data(absolute_)[i] = tolerance * system.scale()[i];
    }
    open();
    if (tangent.count() > 0) open_tangent();
  }
  Ida(const Ida&) = delete;
  Ida& operator=(const Ida&) = delete;
  ~Ida() override {
    IDAFree(&ida_);
    SUNLinSolFree(solver_);
    SUNMatDestroy(matrix_);
    for (N_Vector* many : {s_, ds_, absolute_s_})
      if (many) N_VDestroyVectorArray(many, tangent_.count());
    for (N_Vector v : {y_, dy_, kinds_, absolute_, work_}) N_VDestroy(v);
    SUNContext_Free(&context_);
  }

  void march(double end, State& state, Eigen::MatrixXd& S, Watcher* watcher) {
    watcher_ = watcher;
    tau_.reset();
    load(state, S);
    // what has no rate of its own is under no control of error: it follows the sources by the length of the steps
    check(IDASetMaxStep(ida_, (end - state.time) / 200), "IDASetMaxStep");
    consistent_.settle(state.time, flow_, data(y_), data(dy_));
    settle(state.time);
    double a = state.time;
    for (double b : stops(system_, state.time, end)) {
      advance(a, b);
      consistent_.settle(b, flow_, data(y_), data(dy_));
      settle(b);
      a = b;
    }
    const int n = system_.size();
    state.time = end;
    state.y.assign(data(y_), data(y_) + n), state.dy.assign(data(dy_), data(dy_) + n);
    S = S_;
  }

  const Eigen::VectorXd& y(double t, int derivative) override {
    check(IDAGetDky(ida_, t, derivative, work_), "IDAGetDky");
    std::copy_n(data(work_), system_.size(), value_.data());
    return value_;
  }
  const Eigen::MatrixXd& S(double t) override {
    for (int i = 0; i < tangent_.count(); ++i) {
      check(IDAGetSensDky1(ida_, t, 0, i, work_), "IDAGetSensDky1");
      std::copy_n(data(work_), system_.size(), seen_S().col(i).data());
    }
    return seen_;
  }

 private:
  void load(const State& state, const Eigen::MatrixXd& S) {
    std::copy(state.y.begin(), state.y.end(), data(y_));
    std::copy(state.dy.begin(), state.dy.end(), data(dy_));
    S_ = S;
  }
  Eigen::MatrixXd& seen_S() {
    if (seen_.size() == 0) seen_.resize(system_.size(), tangent_.count());
    return seen_;
  }
  void settle(double t) { tangent_.settle(t, data(y_), data(dy_), S_, dS_); }

  void advance(double a, double b) {
    for (int events = 0; a < b; ++events) {
      if (events > 10000)
        numerics_error("the network stopped at t = {:.9g} s: a valve opens and closes without end", a);
      a = to_event(a, b);
    }
  }

  /// Integrates to b or to the first event before it, where the switch is thrown; returns the time reached.
  double to_event(double a, double b) {
    if (b - a < 1e-13 * (std::abs(a) + std::abs(b))) return b;
    begin(a, b);
    bool fresh = true;
    for (long steps = 0; steps < 1000000; ++steps) {
      double t = a;
      const int flag = IDASolve(ida_, b, &t, y_, dy_, IDA_ONE_STEP);
      if (flag < 0) return go_on(flag, t, fresh);
      if (watcher_) watcher_->step(*this, a, t, fresh, tau_);
      tau_.reset(), fresh = false, a = t;
      if (flag == IDA_ROOT_RETURN || flag == IDA_TSTOP_RETURN) {
        read_sensitivities();
        if (flag == IDA_ROOT_RETURN) throw_switches(t);
        return flag == IDA_ROOT_RETURN ? t : b;
      }
    }
    numerics_error("the network and its sensitivities take too many steps at t = {:.9g} s", a);
  }

  void begin(double a, double b) {
    tangent_.piece(a, b);
    settle(a);
    check(IDAReInit(ida_, a, y_, dy_), "IDAReInit");
    check(SUNLinSol_KLUReInit(solver_, matrix_, system_.pattern().nonZeros(), SUNKLU_REINIT_PARTIAL),
          "KLUReInit");
    for (int i = 0; i < tangent_.count(); ++i) {
      std::copy_n(S_.col(i).data(), system_.size(), data(s_[i]));
      std::copy_n(dS_.col(i).data(), system_.size(), data(ds_[i]));
    }
    if (tangent_.count() > 0) check(IDASensReInit(ida_, IDA_STAGGERED, s_, ds_), "IDASensReInit");
    if (const int n = system_.switch_count(); n > 0) {
      std::vector<int> direction(n);
      for (int k = 0; k < n; ++k) direction[k] = system_.on(k, data(y_)) ? -1 : 1;
      check(IDASetRootDirection(ida_, direction.data()), "IDASetRootDirection");
    }
    check(IDASetStopTime(ida_, b), "IDASetStopTime");
  }

  /// As network/engine: where Newton's iteration fails after some steps, from consistent values at order 1.
  double go_on(int flag, double t, bool fresh) {
    if (flag != IDA_CONV_FAIL || fresh) {
      char* name = IDAGetReturnFlagName(flag);
      const std::string reason = name;
      free(name);
      numerics_error("the network and its sensitivities stopped at t = {:.9g} s ({})", t, reason);
    }
    read_sensitivities();
    consistent_.settle(t, flow_, data(y_), data(dy_));
    settle(t);
    return t;
  }

  void read_sensitivities() {
    if (tangent_.count() == 0) return;
    double t = 0;
    check(IDAGetSens(ida_, &t, s_), "IDAGetSens");
    for (int i = 0; i < tangent_.count(); ++i) std::copy_n(data(s_[i]), system_.size(), S_.col(i).data());
  }

  void throw_switches(double t) {
    std::vector<int> found(system_.switch_count());
    check(IDAGetRootInfo(ida_, found.data()), "IDAGetRootInfo");
    settle(t);
    const auto first = std::find_if(found.begin(), found.end(), [](int f) { return f != 0; });
    const int k = static_cast<int>(first - found.begin());
    tau_ = tangent_.event_time(k, t, flow_, data(y_), data(dy_), S_);
    const Eigen::VectorXd rate = Eigen::Map<Eigen::VectorXd>(data(dy_), system_.size());
    for (int j = 0; j < system_.switch_count(); ++j)
      if (found[j] != 0) system_.throw_switch(j, data(y_));
    for (int& f : found) f = f != 0;
    consistent_.settle(t, flow_, data(y_), data(dy_), found);
    for (int j : system_.states()) S_.row(j) += (rate[j] - data(dy_)[j]) * *tau_;
    settle(t);
  }

  void open() {
    ida_ = IDACreate(context_);
    check(IDAInit(ida_, residual, 0.0, y_, dy_), "IDAInit");
    check(IDASVtolerances(ida_, tolerance, absolute_), "IDASVtolerances");
    check(IDASetId(ida_, kinds_), "IDASetId");
    check(IDASetSuppressAlg(ida_, SUNTRUE), "IDASetSuppressAlg");
    check(IDASetUserData(ida_, this), "IDASetUserData");
    check(IDASetErrFile(ida_, nullptr), "IDASetErrFile");
    matrix_ = jacobian_.matrix(context_);
    solver_ = SUNLinSol_KLU(y_, matrix_, context_);
    check(IDASetLinearSolver(ida_, solver_, matrix_), "IDASetLinearSolver");
    check(IDASetJacFn(ida_, jacobian), "IDASetJacFn");
    if (system_.switch_count() == 0) return;
    check(IDARootInit(ida_, system_.switch_count(), guards), "IDARootInit");
    check(IDASetNoInactiveRootWarn(ida_), "IDASetNoInactiveRootWarn");
  }

  void open_tangent() {
    const int n = tangent_.count();
    s_ = N_VCloneVectorArray(n, y_), ds_ = N_VCloneVectorArray(n, y_),
    absolute_s_ = N_VCloneVectorArray(n, y_);
    for (int i = 0; i < n; ++i) {
      N_VConst(0, s_[i]), N_VConst(0, ds_[i]);
      for (int j = 0; j < system_.size(); ++j)
        data(absolute_s_[i])[j] = sensitivity_tolerance * system_.scale()[j];
    }
    check(IDASensInit(ida_, n, IDA_STAGGERED, tangent_residual, s_, ds_), "IDASensInit");
    check(IDASensSVtolerances(ida_, sensitivity_tolerance, absolute_s_), "IDASensSVtolerances");
    check(IDASetSensErrCon(ida_, SUNTRUE), "IDASetSensErrCon");
  }

  static int residual(double t, N_Vector y, N_Vector dy, N_Vector f, void* user) {
    auto& self = *static_cast<Ida*>(user);
    self.system_.residual(t, data(y), data(dy), self.flow_, data(f));
    return 0;
  }

  static int tangent_residual(int n, double t, N_Vector y, N_Vector dy, N_Vector, N_Vector* s, N_Vector* ds,
                              N_Vector* f, void* user, N_Vector, N_Vector, N_Vector) {
    std::vector<const double*> S(n), dS(n);
    std::vector<double*> F(n);
    for (int i = 0; i < n; ++i) S[i] = data(s[i]), dS[i] = data(ds[i]), F[i] = data(f[i]);
    static_cast<Ida*>(user)->tangent_.residual(t, data(y), data(dy), S, dS, F);
    return 0;
  }

  static int guards(double t, N_Vector y, N_Vector dy, double* g, void* user) {
    guards_to_cross(static_cast<Ida*>(user)->system_, t, data(y), data(dy), g);
    return 0;
  }

  static int jacobian(double t, double cj, N_Vector y, N_Vector dy, N_Vector, SUNMatrix J, void* user,
                      N_Vector, N_Vector, N_Vector) {
    static_cast<Ida*>(user)->jacobian_.write(t, data(y), data(dy), cj, J);
    return 0;
  }

  const System& system_;
  Consistent& consistent_;
  Tangent& tangent_;
  Watcher* watcher_ = nullptr;
  std::vector<double> flow_;
  IdaJacobian jacobian_;
  Eigen::VectorXd value_;
  Eigen::MatrixXd S_, dS_, seen_;
  std::optional<Eigen::RowVectorXd> tau_;  // of the event the next step begins at
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr, dy_ = nullptr, kinds_ = nullptr, absolute_ = nullptr, work_ = nullptr;
  N_Vector *s_ = nullptr, *ds_ = nullptr, *absolute_s_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  void* ida_ = nullptr;
};

TangentEngine::TangentEngine(const System& system, Consistent& consistent, Tangent& tangent)
    : ida_(std::make_unique<Ida>(system, consistent, tangent)) {}
TangentEngine::~TangentEngine() = default;

void TangentEngine::march(double end, State& state, Eigen::MatrixXd& S, Watcher* watcher) {
  ida_->march(end, state, S, watcher);
}

}  // namespace ostium::network
