/// Messages to the user: on the terminal, in log.txt once there is a results folder, and kept for the
/// summary.
///
/// Libraries call `log::info` and `log::warn`; who listens is decided by app/. Without a listener warnings go
/// to stderr.
#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ostium::log {

void write_info(const std::string& text);
void write_warning(const std::string& text);

template <class... Args>
void info(fmt::format_string<Args...> text, Args&&... args) {
  write_info(fmt::format(text, std::forward<Args>(args)...));
}
template <class... Args>
void warn(fmt::format_string<Args...> text, Args&&... args) {
  write_warning(fmt::format(text, std::forward<Args>(args)...));
}

/// From now on everything is also written to this file (replaced if it exists, or continued).
void open_file(const std::filesystem::path& file, bool append = false);
void close_file();
/// Whether info and warnings appear on the terminal (info: stdout, warnings: stderr). Default true.
void show_on_terminal(bool on);

/// All warnings since the start or the last `forget_warnings`, in order.
const std::vector<std::string>& warnings();
void forget_warnings();
/// Takes in the warnings of an earlier part of the run, in front and each text once; nobody is told again.
void recall_warnings(const std::vector<std::string>& earlier);

/// A line that must be wiped before a message is printed and redrawn after it (the progress line); empty:
/// none.
void set_status_line(const std::string& line);

}  // namespace ostium::log
