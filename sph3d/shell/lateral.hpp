/// The wall of a vessel without its openings: an open surface, fit for closest points. Internal to shell/.
#pragma once
#include <string>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

/// Points keep their numbers.
template <int D>
Surface<D> lateral(const Surface<D>& surface);

/// "at (x, y, z) mm" for a sentence.
template <int D>
std::string place(const Vec<D>& x);

}  // namespace ostium::sph3d
