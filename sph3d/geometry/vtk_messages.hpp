/// Catches what VTK would print, for as long as it lives. Internal to geometry/ and io/.
#pragma once
#include <string>

namespace ostium::sph3d {

class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The first error since construction, without VTK's places in its own source; empty if there was none.
  std::string first_error() const;
};

}  // namespace ostium::sph3d
