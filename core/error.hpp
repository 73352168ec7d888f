/// The three kinds of error of the project. Libraries throw; only app/ prints and exits.
///
///   UserError      what a user can mend: where, what was found, what is allowed, how to mend it   exit code
///   2 NumericsError  blow-up, no convergence: what, where in space, when, the limiting quantity      exit
///   code 3 OSTIUM_ASSERT  a bug: the values that contradict the code's own belief exit code 70
#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace ostium {

struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct NumericsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Bug : std::logic_error {
  using std::logic_error::logic_error;
};

template <class... Args>
[[noreturn]] void user_error(fmt::format_string<Args...> text, Args&&... args) {
  throw UserError(fmt::format(text, std::forward<Args>(args)...));
}

template <class... Args>
[[noreturn]] void numerics_error(fmt::format_string<Args...> text, Args&&... args) {
  throw NumericsError(fmt::format(text, std::forward<Args>(args)...));
}

/// Checked in every build: OSTIUM_ASSERT(n > 0, "particles: {}", n).
#define OSTIUM_ASSERT(condition, ...)                                                                \
  do {                                                                                               \
    if (!(condition)) [[unlikely]]                                                                   \
      throw ::ostium::Bug(fmt::format("{}:{}: {} does not hold; {}", __FILE__, __LINE__, #condition, \
                                      fmt::format(__VA_ARGS__)));                                    \
  } while (false)

}  // namespace ostium
