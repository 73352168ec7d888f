/// An X display without a screen, for as long as it lives. Internal to io/.
#pragma once
#include <sys/types.h>

#include <optional>
#include <string>

namespace ostium::sph3d {

/// Starts Xvfb and points DISPLAY to it; where Xvfb is missing, keeps the display of DISPLAY. Throws UserError when
/// there is neither. The destructor ends Xvfb and restores DISPLAY.
class VirtualDisplay {
 public:
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  void stop();

  pid_t server_ = -1;
  std::optional<std::string> display_before_;
};

}  // namespace ostium::sph3d
