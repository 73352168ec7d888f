/// What a refusal must be.
#pragma once
#include <stdexcept>
#include <string>

#include "core/error.hpp"
#include "core/log.hpp"
#include "core/text.hpp"

namespace ostium::fuzz {

inline void check_sentence(const std::string& text, const std::string& file) {
  const bool one_line = text.find('\n') == std::string::npos && first_bad_byte(text) == std::string::npos;
  constexpr std::size_t longest = 8000;
  if (!one_line || text.size() > longest || text.find(file) == std::string::npos)
    throw std::logic_error("a refusal that is not one line naming " + file + ": " + text);
}

/// Runs `read`; every refusal must be one line that names `file`.
template <class Read>
void accepted_or_refused(const std::string& file, Read read) {
  log::show_on_terminal(false);
  log::forget_warnings();
  try {
    read();
  } catch (const UserError& e) {
    check_sentence(e.what(), file);
  } catch (const NumericsError&) {
  }
}

/// Files outside the folder of the test would make a run depend on the machine.
inline bool names_other_files(std::string_view content) {
  for (const char* place : {"..", "/proc", "/dev", "/sys", "/etc", "/home", "/root", "/tmp", "/var", "/usr"})
    if (content.find(place) != std::string_view::npos) return true;
  return false;
}

/// Where the files are that texts may name: OSTIUM_FUZZ_FILES/inflow.csv.
inline std::string in_folder(const char* name) { return std::string(OSTIUM_FUZZ_FILES "/") + name; }

}  // namespace ostium::fuzz
