/// Checks shared by the generators. Internal to geometry/.
#pragma once
#include "core/error.hpp"

namespace ostium::sph3d {

inline void check_positive(const char* name, double value) {
  if (!(value > 0) || value > 1e3) user_error("{}: a positive size, found {}", name, value);
}

}  // namespace ostium::sph3d
