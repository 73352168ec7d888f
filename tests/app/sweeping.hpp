/// A study of a Windkessel that is swept, and what its results say.
#pragma once
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ostium::test {

inline constexpr const char* rcr = R"(network:
  blocks:
    in: {type: flow_source, to: A, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 s}}
    bed: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 3e-9 m3/Pa, Rd: 4e8 Pa.s/m3}
time: {period: 1 s}
output: {every: 20 ms}
sweep:
  sample: latin_hypercube
  count: 50
  parameters:
    - {name: bed.Rd, low: 100 mmHg.s/L, high: 4e8 Pa.s/m3}
    - {name: bed.C, low: 1e-9 m3/Pa, high: 1e-8 m3/Pa, scale: log}
  results: [mean p:A, pulse p:A]
)";

inline constexpr double q0 = 90e-6, Rp = 1e7;

class Sweeping : public ProgramTest {
 protected:
  static std::string with(const std::string& from, const std::string& to, std::string text = rcr) {
    return text.replace(text.find(from), from.size(), to);
  }
  std::vector<std::string> lines(const std::string& file) const {
    std::istringstream stream(content(file));
    std::vector<std::string> all;
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
  }
  static std::vector<std::string> cells(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> all;
    for (std::string cell; std::getline(stream, cell, ',');) all.push_back(cell);
    return all;
  }
  nlohmann::json summary(const std::string& folder) const {
    return nlohmann::json::parse(content(folder + "/summary.json"));
  }

  /// Starts a sweep of `count` samples and ends it by a signal when some blocks are written; returns what it said.
  std::string cut_short(const std::string& signal, int count) const {
    return shell(
               fmt::format(
                   "{} sweep case.yaml -q -o stopped --set sweep.count={} & pid=$!; for i in $(seq 3000); do "
                   "[ \"$(cat stopped/sweep.csv 2>/dev/null | wc -l)\" -gt 40 ] && break; sleep 0.01; done; "
                   "kill -{} $pid; wait $pid; echo code $?",
                   OSTIUM_BINARY, count, signal))
        .text;
  }
};

}  // namespace ostium::test
