/// The outline of an opening as a closed polygon in the opening's own plane (origin at its centre, axes
/// `tangents`).
#pragma once
#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

Surface<2> flat_outline(const Opening<3>& opening, const Eigen::Matrix<double, 3, 2>& frame);

}  // namespace ostium::sph3d
