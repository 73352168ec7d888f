#include "sph3d/io/virtual_display.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "core/error.hpp"

namespace ostium::sph3d {
namespace {

/// In the child after fork(): nothing but system calls until exec. Its own process group, so that the interrupt key
/// ends the picture through us and not the server under our feet.
[[noreturn]] void become_server(int report) {
  setpgid(0, 0);
  const int null = open("/dev/null", O_RDWR);
  dup2(null, 0), dup2(null, 1), dup2(null, 2);
  dup2(report, 3);
  fcntl(3, F_SETFD, 0);  // stays open when `report` is 3 already
  execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1600x1000x24", "-nolisten", "tcp", "-noreset",
         static_cast<char*>(nullptr));
  _exit(127);
}

/// The number the server writes when it is ready; empty when it ends or stays silent for 20 s.
std::string reported_number(int from) {
  std::string text;
  pollfd ready{from, POLLIN, 0};
  while (text.find('\n') == text.npos) {
    if (poll(&ready, 1, 20000) <= 0) return {};
    char c;
    if (read(from, &c, 1) != 1) return {};
    text += c;
  }
  return text.substr(0, text.find('\n'));
}

/// Whether DISPLAY names a local display that is not there: X would end the whole program.
bool dangling(const std::string& display) {
  if (display.empty() || display[0] != ':') return display.empty();
  const auto number = display.substr(1, display.find('.') - 1);
  return access(("/tmp/.X11-unix/X" + number).c_str(), F_OK) != 0;
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
  if (const char* display = std::getenv("DISPLAY")) display_before_ = display;
  int report[2];
  std::string number;
  if (pipe2(report, O_CLOEXEC) == 0) {
    server_ = fork();
    if (server_ == 0) become_server(report[1]);
    close(report[1]);
    if (server_ > 0) number = reported_number(report[0]);
    close(report[0]);
  }
  if (!number.empty()) {
    setenv("DISPLAY", (":" + number).c_str(), 1);
    return;
  }
  stop();
  if (!display_before_ || dangling(*display_before_))
    user_error(
        "no display to draw the picture on: Xvfb could not be started and DISPLAY names none; install Xvfb "
        "(Debian: apt install xvfb)");
}

void VirtualDisplay::stop() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
  server_ = -1;
}

VirtualDisplay::~VirtualDisplay() {
  if (server_ <= 0) return;
  stop();
  if (display_before_)
    setenv("DISPLAY", display_before_->c_str(), 1);
  else
    unsetenv("DISPLAY");
}

}  // namespace ostium::sph3d
