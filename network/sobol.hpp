/// Sobol indices of a result: how much of its variance the parameters account for.
///
///   first order   S_k = Var[E(f|x_k)]/Var f        estimated by   1/N sum f(B) (f(A_k) - f(A)) / V
///   total         T_k = E[Var(f|x_not k)]/Var f    estimated by   1/2N sum (f(A) - f(A_k))^2 / V
///
///   A, B     two independent samples of all parameters; A_k   A with the k-th column of B
///   V        1/2N sum (f(A) - m)^2 + (f(B) - m)^2,   m   mean of f over A and B; f is taken from it
///   half     half the width of the 95 % confidence interval: 1.96 standard errors of the ratio, by the delta method
///
/// Base samples in which a run has failed are left out. Where f does not vary the indices are not a number.
/// Source: Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, table 2 (b) and (f) (Jansen). Not checked: that the rows
/// come from a Saltelli design (network/design); that a base sample is large enough, which the intervals tell.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace ostium::network {

struct SobolIndex {
  double first = 0, first_half = 0;
  double total = 0, total_half = 0;
};

struct Sobol {
  double mean = 0, variance = 0;
  std::int64_t base_samples = 0;  // that are complete
  std::vector<SobolIndex> parameters;
};

/// f(row) of a design of `base_samples` (parameters + 2) rows; not a number where the run has failed.
Sobol sobol(std::int64_t base_samples, int parameters, const std::function<double(std::int64_t)>& f);

}  // namespace ostium::network
