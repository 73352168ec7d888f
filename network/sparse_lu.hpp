/// Sparse LU of matrices that share one pattern: ordered once, factored with pivoting, then refactored with its pivots.
///
///   P R A Q = L U + F,   A in compressed columns, R scales rows, F stands above the diagonal blocks of L U
///
/// The factors are copied out of KLU, which steps through them column by column and divides by the pivots. Here every row is
/// divided by its pivot beforehand, and a solution is one row of eliminations x_row -= value x_column.
/// `refactor` keeps the pivots where they still serve (no pivot lost more than ten digits against the others) and
/// chooses new ones where they do not. Source: Davis & Palamadai Natarajan, ACM TOMS 37 (2010) 36: KLU. Not checked:
/// the condition of A, beyond a pivot that vanishes.
#pragma once
#include <klu.h>

#include <memory>
#include <span>
#include <vector>

namespace ostium::network {

class SparseLu {
 public:
  /// start: n + 1 offsets of the columns, row: row of each entry. Both must outlive this object.
  SparseLu(int n, const int* start, const int* row);
  /// Another matrix of the same pattern, in the same order; nothing factored yet.
  explicit SparseLu(const SparseLu& pattern);
  SparseLu& operator=(const SparseLu&) = delete;
  ~SparseLu();

  /// False: the matrix is singular, and nothing may be solved.
  bool factor(const double* values);
  bool refactor(const double* values);
  /// b: right-hand side in, solution out.
  void solve(std::span<double> b) const;
  /// The same for the transposed matrix.
  void solve_transposed(std::span<double> b) const;
  /// Smallest pivot over the largest.
  double pivot_ratio();

 private:
  struct Columns {
    std::vector<int> start, row;
    std::vector<double> value;
    void resize(int n, int entries);
  };
  struct Elimination {
    double value;
    int row, column;
  };
  void copy_factors();
  void eliminate(int column, double pivot, const Columns& columns, int first, int last);

  int n_;
  const int *start_, *row_;
  mutable klu_common common_{};
  std::shared_ptr<klu_symbolic> symbolic_;
  klu_numeric* numeric_ = nullptr;
  Columns lower_, upper_, above_;  // L with its ones first in each column, U with its pivots last, F
  std::vector<int> row_of_, column_of_, block_;  // P, Q, first rows of the blocks
  std::vector<double> pivot_, over_pivot_, row_scale_;
  /// Forwards with L, backwards with U and F, block by block from the last.
  std::vector<Elimination> eliminations_;
  mutable std::vector<double> x_;
};

}  // namespace ostium::network
