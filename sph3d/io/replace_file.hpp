/// Writing a file beside its name and renaming it. Internal to io/.
#pragma once
#include <filesystem>

#include "core/error.hpp"

namespace ostium::sph3d {

/// Calls write(path) with a temporary name in the same folder, then puts the result in place.
template <class Write>
void replace_file(const std::filesystem::path& file, Write write) {
  const std::filesystem::path beside = file.string() + ".part";
  std::error_code error;
  if (write(beside))
    std::filesystem::rename(beside, file, error);
  else
    error = std::make_error_code(std::errc::io_error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  user_error("{}: cannot be written ({}); is the folder there, writable, the disk not full?", file.string(),
             error.message());
}

}  // namespace ostium::sph3d
