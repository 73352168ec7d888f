/// Small vectors and matrices of the space dimension D (2 or 3), double precision.
#pragma once
#include <Eigen/Dense>

namespace ostium {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;
template <int D>
using Mat = Eigen::Matrix<double, D, D>;
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

inline constexpr double pi = 3.14159265358979323846;

}  // namespace ostium
