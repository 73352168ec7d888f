#include "bench/svzerod_reference.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace ostium::bench {
namespace {

struct Series {
  std::vector<double> time, y;

  double at(double t) const {
    const auto k = std::lower_bound(time.begin(), time.end(), t - 1e-9) - time.begin();
    if (k == 0) return y.front();
    if (k == static_cast<std::ptrdiff_t>(time.size())) return y.back();
    const double s = (t - time[k - 1]) / (time[k] - time[k - 1]);
    return y[k - 1] + s * (y[k] - y[k - 1]);
  }
};

std::map<std::string, Series> read_series(const std::filesystem::path& file) {
  std::map<std::string, Series> all;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    const auto comma = line.find(',');
    auto& series = all[line.substr(0, comma)];
    char* next = nullptr;
    series.time.push_back(std::strtod(line.c_str() + comma + 1, &next));
    series.y.push_back(std::strtod(next + 1, nullptr));
  }
  return all;
}

double relative_distance(const Series& ours, const std::vector<double>& times, const std::vector<double>& y) {
  double square = 0, size = 1e-300;
  for (std::size_t k = 0; k < times.size(); ++k)
    square += std::pow(ours.at(times[k]) - y[k], 2), size += y[k] * y[k];
  return std::sqrt(square / size);
}

}  // namespace

Distance distance_to_reference(const std::filesystem::path& results, const std::filesystem::path& data,
                               const std::string& name) {
  const auto ours = read_series(results / "svzerod.csv");
  const auto reference = nlohmann::json::parse(std::ifstream(data / "converged" / (name + ".json")));
  const auto times = reference.at("time").get<std::vector<double>>();
  Distance worst;
  for (const auto& [series, y] : reference.at("y").items()) {
    const auto found = ours.find(series);
    const double error = found == ours.end()
                             ? INFINITY
                             : relative_distance(found->second, times, y.get<std::vector<double>>());
    if (!(error <= worst.error)) worst = {error, series};
  }
  return worst;
}

}  // namespace ostium::bench
