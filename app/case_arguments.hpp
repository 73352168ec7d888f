/// The part of the command line that all commands on a case share.
#pragma once
#include <string>
#include <vector>

#include "app/case.hpp"

namespace CLI {
class App;
}

namespace ostium::app {

struct CaseArguments {
  std::string file, surface;
  std::vector<std::string> set;  // KEY=VALUE
  int threads = 0;

  void add_to(CLI::App& command);
  Case read() const;
  int thread_count() const;
  /// The arguments as one would type them.
  std::string text() const;
};

}  // namespace ostium::app
