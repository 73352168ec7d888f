/// dF/dy + cj dF/dy' of a network's equations in the sparse matrix of IDA and IDAS.
///
///   cj   1/s   of the step, from the integrator
///
/// The pattern is that of the system (columns compressed). Source: SUNDIALS, IDALsJacFn. Not checked: that the matrix was made
/// for this system.
#pragma once
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <vector>

#include "network/system.hpp"

namespace ostium::network {

class IdaJacobian {
 public:
  explicit IdaJacobian(const System& system)
      : system_(system), d_y_(system.pattern().nonZeros()), d_dy_(system.pattern().nonZeros()) {}

  SUNMatrix matrix(SUNContext context) const {
    return SUNSparseMatrix(system_.size(), system_.size(), system_.pattern().nonZeros(), CSC_MAT, context);
  }

  void write(double t, const double* y, const double* dy, double cj, SUNMatrix J) {
    system_.jacobian(t, y, dy, d_y_.data(), d_dy_.data());
    const auto& pattern = system_.pattern();
    std::copy_n(pattern.outerIndexPtr(), pattern.cols() + 1, SM_INDEXPTRS_S(J));
    std::copy_n(pattern.innerIndexPtr(), pattern.nonZeros(), SM_INDEXVALS_S(J));
    for (int k = 0; k < pattern.nonZeros(); ++k) SM_DATA_S(J)[k] = d_y_[k] + cj * d_dy_[k];
  }

 private:
  const System& system_;
  std::vector<double> d_y_, d_dy_;
};

}  // namespace ostium::network
