#include "core/log.hpp"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>
#include <mutex>

#include "core/error.hpp"

namespace ostium::log {
namespace {

/// Info on stdout, warnings on stderr, around the status line.
class TerminalSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  void status(const std::string& line) {
    std::lock_guard lock(mutex_);
    status_ = line;
  }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    if (!status_.empty()) std::fputs("\r\x1b[K", stdout), std::fflush(stdout);
    std::FILE* stream = message.level >= spdlog::level::warn ? stderr : stdout;
    std::fwrite(text.data(), 1, text.size(), stream);
    std::fflush(stream);
    if (!status_.empty()) std::fputs(status_.c_str(), stdout), std::fflush(stdout);
  }
  void flush_() override { std::fflush(stdout); }

 private:
  std::string status_;
};

/// The sinks of the one program; a logger of the library is a list of them.
struct Outlets {
  std::shared_ptr<TerminalSink> terminal = std::make_shared<TerminalSink>();
  spdlog::logger logger{"ostium", terminal};
  std::shared_ptr<spdlog::sinks::sink> file;
  std::vector<std::string> warnings;
  std::mutex mutex;

  Outlets() { terminal->set_formatter(formatter()); }
  static std::unique_ptr<spdlog::formatter> formatter() {
    return std::make_unique<spdlog::pattern_formatter>("%v", spdlog::pattern_time_type::local, "\n");
  }
};

Outlets& outlets() {
  static Outlets all;
  return all;
}

}  // namespace

void write_info(const std::string& text) { outlets().logger.info("{}", text); }

void write_warning(const std::string& text) {
  {
    std::lock_guard lock(outlets().mutex);
    outlets().warnings.push_back(text);
  }
  outlets().logger.warn("warning: {}", text);
}

void open_file(const std::filesystem::path& file, bool append) {
  close_file();
  try {
    outlets().file = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file.string(), !append);
  } catch (const spdlog::spdlog_ex&) {
    user_error("{}: the log cannot be written", file.string());
  }
  outlets().file->set_formatter(Outlets::formatter());
  outlets().logger.sinks().push_back(outlets().file);
  outlets().logger.flush_on(spdlog::level::info);
}

void close_file() {
  std::erase(outlets().logger.sinks(), outlets().file);
  outlets().file.reset();
}

void show_on_terminal(bool on) {
  outlets().terminal->set_level(on ? spdlog::level::info : spdlog::level::off);
}

const std::vector<std::string>& warnings() { return outlets().warnings; }
void forget_warnings() { outlets().warnings.clear(); }

void recall_warnings(const std::vector<std::string>& earlier) {
  auto all = earlier;
  for (const auto& text : outlets().warnings)
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
  outlets().warnings = std::move(all);
}

void set_status_line(const std::string& line) { outlets().terminal->status(line); }

}  // namespace ostium::log
