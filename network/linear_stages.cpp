#include <algorithm>
#include <cmath>
#include <list>

#include "network/stage_solver.hpp"

namespace ostium::network {

namespace {

class LinearStages final : public StageSolver {
 public:
  explicit LinearStages(const System& system)
      : system_(system),
        ordered_(system.size(), system.pattern().outerIndexPtr(), system.pattern().innerIndexPtr()),
        d_y_(system.pattern().nonZeros()),
        d_dy_(d_y_.size()),
        f_(system.size()) {
    const std::vector<double> zero(system.size(), 0.0);
    system.jacobian(0, zero.data(), zero.data(), d_y_.data(), d_dy_.data());
    const int* start = system.pattern().outerIndexPtr();
    for (int j : system.differential_unknowns())
      for (int k = start[j]; k < start[j + 1]; ++k)
        if (d_dy_[k] != 0) storage_.push_back({system.pattern().innerIndexPtr()[k], j, d_dy_[k]});
  }

  void forget() override {}   // nothing depends on what came before
  void changed() override {}  // a linear network has no switches

  bool begin_step(double, const double*, const double*, double hg) override {
    hg_ = hg;
    const auto known =
        std::find_if(factored_.begin(), factored_.end(), [hg](const auto& f) { return f.hg == hg; });
    if (known == factored_.end()) return factor(hg);
    factored_.splice(factored_.begin(), factored_, known);
    return true;
  }

  bool solve(double t, std::span<const double> port_flow, const double* base, double* y, double* dy,
             double) override {
    system_.forcing(t, port_flow, f_.data());
    for (const auto& s : storage_) f_[s.row] -= s.value * base[s.column] / hg_;
    factored_.front().lu->solve(f_);
    for (int j = 0; j < system_.size(); ++j) y[j] = -f_[j] * system_.scale()[j];
    for (int j : system_.differential_unknowns()) dy[j] = (y[j] - base[j]) / hg_;
    return true;
  }

  void damp(double* error) override {
    std::fill(f_.begin(), f_.end(), 0.0);
    for (const auto& s : storage_) f_[s.row] += s.value * error[s.column] / hg_;
    factored_.front().lu->solve(f_);
    for (int j : system_.states()) error[j] = f_[j] * system_.scale()[j];
  }

  bool renew() override { return false; }

 private:
  struct Entry {
    int row, column;
    double value;
  };
  struct Factored {
    double hg;
    std::unique_ptr<SparseLu> lu;
  };

  bool factor(double hg) {
    constexpr std::size_t kept = 8;  // lengths between kinks come back from cycle to cycle
    if (factored_.size() < kept) factored_.push_back({0, std::make_unique<SparseLu>(ordered_)});
    factored_.splice(factored_.begin(), factored_, std::prev(factored_.end()));
    std::vector<double> matrix(d_y_.size());
    const int* start = system_.pattern().outerIndexPtr();
    for (int j = 0; j < system_.size(); ++j)
      for (int k = start[j]; k < start[j + 1]; ++k)
        matrix[k] = (d_y_[k] + d_dy_[k] / hg) * system_.scale()[j];
    const bool good = factored_.front().lu->factor(matrix.data());
    factored_.front().hg = good ? hg : 0;
    return good;
  }

  const System& system_;
  SparseLu ordered_;
  std::vector<double> d_y_, d_dy_, f_;
  std::vector<Entry> storage_;
  std::list<Factored> factored_;  // the one in use first
  double hg_ = 0;
};

}  // namespace

std::unique_ptr<StageSolver> make_linear_stages(const System& system) {
  return std::make_unique<LinearStages>(system);
}

}  // namespace ostium::network
