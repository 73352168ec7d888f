#include "network/sparse_lu.hpp"

#include "core/error.hpp"

namespace ostium::network {

namespace {

/// KLU's C interface does not know const; it does not write to what it is given.
int* open(const int* p) { return const_cast<int*>(p); }
double* open(const double* p) { return const_cast<double*>(p); }

}  // namespace

SparseLu::SparseLu(int n, const int* start, const int* row) : n_(n), start_(start), row_(row) {
  klu_defaults(&common_);
  common_.halt_if_singular = 1;
  if (n == 0) return;
  symbolic_ = {klu_analyze(n, open(start), open(row), &common_), [](klu_symbolic* s) {
                 klu_common common;
                 klu_defaults(&common);
                 klu_free_symbolic(&s, &common);
               }};
}

SparseLu::SparseLu(const SparseLu& pattern)
    : n_(pattern.n_),
      start_(pattern.start_),
      row_(pattern.row_),
      common_(pattern.common_),
      symbolic_(pattern.symbolic_) {}

SparseLu::~SparseLu() { klu_free_numeric(&numeric_, &common_); }

bool SparseLu::factor(const double* values) {
  if (n_ == 0) return true;
  if (!symbolic_) return false;  // no permutation without zeros on the diagonal: singular by its pattern
  klu_free_numeric(&numeric_, &common_);
  numeric_ = klu_factor(open(start_), open(row_), open(values), symbolic_.get(), &common_);
  return numeric_ && common_.status == KLU_OK;
}

bool SparseLu::refactor(const double* values) {
  if (n_ == 0) return true;
  if (!numeric_) return factor(values);
  constexpr double worn = 1e-14;
  if (klu_refactor(open(start_), open(row_), open(values), symbolic_.get(), numeric_, &common_) &&
      common_.status == KLU_OK && pivot_ratio() > worn)
    return true;
  return factor(values);
}

double SparseLu::pivot_ratio() {
  if (n_ == 0) return 1;
  klu_rcond(symbolic_.get(), numeric_, &common_);
  return common_.rcond;
}

void SparseLu::solve(std::span<double> b) const {
  OSTIUM_ASSERT(static_cast<int>(b.size()) == n_ && (n_ == 0 || numeric_), "{} right-hand sides for {}",
                b.size(), n_);
  if (n_ > 0) klu_solve(symbolic_.get(), numeric_, n_, 1, b.data(), &common_);
}

void SparseLu::solve_transposed(std::span<double> b) const {
  OSTIUM_ASSERT(static_cast<int>(b.size()) == n_ && (n_ == 0 || numeric_), "{} right-hand sides for {}",
                b.size(), n_);
  if (n_ > 0) klu_tsolve(symbolic_.get(), numeric_, n_, 1, b.data(), &common_);
}

}  // namespace ostium::network
