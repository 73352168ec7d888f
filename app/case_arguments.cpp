#include "app/case_arguments.hpp"

#include <omp.h>
#include <CLI/CLI.hpp>

namespace ostium::app {

void CaseArguments::add_to(CLI::App& command) {
  command.add_option("case", file, "case file (YAML)")->required();
  command.add_option("--surface", surface, "read the vessel's surface from this file instead");
  command.add_option("--set", set, "change a value of the case: KEY=VALUE, such as time.cycles=1")
      ->allow_extra_args(false);
  command.add_option("--threads", threads, "number of threads; default: OMP_NUM_THREADS, or all")
      ->check(CLI::NonNegativeNumber);
}

Case CaseArguments::read() const {
  Overrides overrides;
  if (!surface.empty()) overrides.surface = std::filesystem::absolute(surface);
  for (const auto& text : set) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      user_error("--set {}: expected KEY=VALUE, for example --set time.cycles=1", text);
    overrides.values.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return read_case(file, overrides);
}

std::string CaseArguments::text() const {
  const auto quoted = [](const std::string& word) {
    return word.find_first_of(" '\"{}[]()*?&;|<>$") == std::string::npos ? word : "'" + word + "'";
  };
  std::string text = quoted(file);
  if (!surface.empty()) text += " --surface " + quoted(surface);
  for (const auto& value : set) text += " --set " + quoted(value);
  return text;
}

int CaseArguments::thread_count() const { return threads > 0 ? threads : omp_get_max_threads(); }

}  // namespace ostium::app
