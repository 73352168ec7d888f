#include "core/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/log.hpp"

namespace ostium {
namespace {

std::string clock_text(double seconds) {
  if (!std::isfinite(seconds) || seconds > 1e7) return "?";
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress::Progress(Options options)
    : options_(options),
      terminal_(isatty(fileno(options.stream))),
      started_(Clock::now()),
      printed_(started_ - std::chrono::hours(terminal_ ? 1 : 0)) {}

Progress::~Progress() { finish(); }

double Progress::seconds_since(Clock::time_point t) const {
  return std::chrono::duration<double>(Clock::now() - t).count();
}

bool Progress::due() const {
  return !options_.quiet &&
         seconds_since(printed_) >= (terminal_ ? options_.terminal_interval : options_.pipe_interval);
}

void Progress::update(double time, long steps, const std::string& extra) {
  if (!due()) return;
  printed_ = Clock::now();
  last_ = line(options_, time, steps, seconds_since(started_), extra);
  if (terminal_) log::set_status_line(last_);
  fmt::print(options_.stream, fmt::runtime(terminal_ ? "\r\x1b[K{}" : "{}\n"), last_);
  std::fflush(options_.stream);
}

void Progress::finish() {
  if (terminal_ && !last_.empty()) {
    log::set_status_line("");
    fmt::print(options_.stream, "\r\x1b[K");
    std::fflush(options_.stream);
  }
  last_.clear();
}

std::string Progress::line(const Options& o, double time, long steps, double wall, const std::string& extra) {
  const double done = o.end > o.start ? std::clamp((time - o.start) / (o.end - o.start), 0.0, 1.0) : 1.0;
  const double left = done > 0 ? wall * (1 - done) / done : std::numeric_limits<double>::infinity();
  const auto with_extra = [&](const std::string& text) { return extra.empty() ? text : text + "  " + extra; };
  if (!o.task.empty())
    return with_extra(fmt::format("{}  {:.0f} %  ETA {}", o.task, 100 * done, clock_text(left)));
  std::string text = fmt::format("{:.4g} / {:.4g} s", time, o.end);
  if (o.period > 0)
    text += fmt::format("  cycle {}", 1 + static_cast<long>(std::floor(time / o.period * (1 + 1e-12))));
  text += fmt::format("  {:.0f} %  {:.3g} steps/s  ETA {}", 100 * done, wall > 0 ? steps / wall : 0.0,
                      clock_text(left));
  return with_extra(text);
}

}  // namespace ostium
