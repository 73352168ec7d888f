/// The version of the program, as the build names it.
#pragma once

namespace ostium::app {

#ifdef OSTIUM_VERSION
inline constexpr const char* version = OSTIUM_VERSION;
#else
inline constexpr const char* version = "unknown";
#endif

}  // namespace ostium::app
