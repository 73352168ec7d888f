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
  if (!numeric_ || common_.status != KLU_OK) return false;
  copy_factors();
  return true;
}

bool SparseLu::refactor(const double* values) {
  if (n_ == 0) return true;
  if (!numeric_) return factor(values);
  constexpr double worn = 1e-14;
  if (!klu_refactor(open(start_), open(row_), open(values), symbolic_.get(), numeric_, &common_) ||
      common_.status != KLU_OK || pivot_ratio() <= worn)
    return factor(values);
  copy_factors();
  return true;
}

void SparseLu::Columns::resize(int n, int entries) {
  start.resize(n + 1), row.resize(entries), value.resize(entries);
}

void SparseLu::copy_factors() {
  lower_.resize(n_, numeric_->lnz), upper_.resize(n_, numeric_->unz), above_.resize(n_, numeric_->nzoff);
  block_.resize(numeric_->nblocks + 1);
  for (auto* permutation : {&row_of_, &column_of_}) permutation->resize(n_);
  row_scale_.resize(n_), x_.resize(n_);
  klu_extract(numeric_, symbolic_.get(), lower_.start.data(), lower_.row.data(), lower_.value.data(),
              upper_.start.data(), upper_.row.data(), upper_.value.data(), above_.start.data(),
              above_.row.data(), above_.value.data(), row_of_.data(), column_of_.data(), row_scale_.data(),
              block_.data(), &common_);
  pivot_.resize(n_), over_pivot_.resize(n_);
  for (int j = 0; j < n_; ++j) {
    pivot_[j] = upper_.value[upper_.start[j + 1] - 1];
    over_pivot_[j] = 1 / pivot_[j];
    row_scale_[j] = over_pivot_[j] / row_scale_[j];
  }
  eliminations_.clear();
  for (int block = numeric_->nblocks - 1; block >= 0; --block) {
    for (int j = block_[block]; j < block_[block + 1]; ++j)
      eliminate(j, pivot_[j], lower_, lower_.start[j] + 1, lower_.start[j + 1]);
    for (int j = block_[block + 1] - 1; j >= block_[block]; --j) {
      eliminate(j, 1, upper_, upper_.start[j], upper_.start[j + 1] - 1);
      eliminate(j, 1, above_, above_.start[j], above_.start[j + 1]);
    }
  }
}

void SparseLu::eliminate(int column, double pivot, const Columns& columns, int first, int last) {
  for (int k = first; k < last; ++k) {
    const int row = columns.row[k];
    eliminations_.push_back({columns.value[k] * pivot * over_pivot_[row], row, column});
  }
}

double SparseLu::pivot_ratio() {
  if (n_ == 0) return 1;
  klu_rcond(symbolic_.get(), numeric_, &common_);
  return common_.rcond;
}

void SparseLu::solve(std::span<double> b) const {
  OSTIUM_ASSERT(static_cast<int>(b.size()) == n_ && (n_ == 0 || numeric_), "{} right-hand sides for {}",
                b.size(), n_);
  double* const x = x_.data();
  for (int i = 0; i < n_; ++i) x[i] = b[row_of_[i]] * row_scale_[i];
  for (const auto& [value, row, column] : eliminations_) x[row] -= value * x[column];
  for (int i = 0; i < n_; ++i) b[column_of_[i]] = x[i];
}

void SparseLu::solve_transposed(std::span<double> b) const {
  OSTIUM_ASSERT(static_cast<int>(b.size()) == n_ && (n_ == 0 || numeric_), "{} right-hand sides for {}",
                b.size(), n_);
  if (n_ > 0) klu_tsolve(symbolic_.get(), numeric_, n_, 1, b.data(), &common_);
}

}  // namespace ostium::network
