#include "case_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ostium::test {

double Signal::at(double t) const {
  if (t <= time.front()) return value.front();
  if (t >= time.back()) return value.back();
  const auto i = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  return value[i - 1] + (value[i] - value[i - 1]) * (t - time[i - 1]) / (time[i] - time[i - 1]);
}

Signal Signal::between(double t0, double t1) const {
  Signal part{{t0}, {at(t0)}};
  for (std::size_t i = 0; i < time.size(); ++i)
    if (time[i] > t0 && time[i] < t1) part.time.push_back(time[i]), part.value.push_back(value[i]);
  part.time.push_back(t1), part.value.push_back(at(t1));
  return part;
}

double Signal::mean() const {
  double sum = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    sum += 0.5 * (value[i] + value[i - 1]) * (time[i] - time[i - 1]);
  return sum / (time.back() - time.front());
}

double Signal::min() const { return *std::min_element(value.begin(), value.end()); }
double Signal::max() const { return *std::max_element(value.begin(), value.end()); }

double rms_difference(const Signal& a, const Signal& b, double period) {
  double sum = 0;
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    const double t = a.time[i] - period * std::floor(a.time[i] / period);
    sum += std::pow(a.value[i] - b.at(t), 2);
  }
  return std::sqrt(sum / static_cast<double>(a.time.size()));
}

std::map<std::string, PortSignals> read_ports(const std::filesystem::path& file) {
  std::map<std::string, PortSignals> ports;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "time_s,port,flow_out_m3_s,pressure_Pa,volume_out_m3");
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    std::string time, name, flow, pressure, volume;
    std::getline(cells, time, ','), std::getline(cells, name, ',');
    std::getline(cells, flow, ','), std::getline(cells, pressure, ','), std::getline(cells, volume, ',');
    const auto add = [&](Signal& s, const std::string& value) {
      s.time.push_back(std::stod(time)), s.value.push_back(std::stod(value));
    };
    add(ports[name].flow_out, flow), add(ports[name].pressure, pressure), add(ports[name].volume_out, volume);
  }
  return ports;
}

Signal column(const Table& table, const std::string& name) {
  const auto at = std::find(table.names.begin(), table.names.end(), name);
  if (at == table.names.end()) throw std::runtime_error("no column " + name);
  return {table.columns[0], table.columns[at - table.names.begin()]};
}

Signal column(const std::filesystem::path& file, const std::string& name) {
  std::ifstream stream(file);
  std::string line, cell;
  const auto cells = [&] {
    std::vector<std::string> all;
    std::getline(stream, line);
    for (std::istringstream rest(line); std::getline(rest, cell, ',');) all.push_back(cell);
    return all;
  };
  const auto names = cells();
  const auto at = std::find(names.begin(), names.end(), name) - names.begin();
  if (at == static_cast<std::ptrdiff_t>(names.size())) throw std::runtime_error("no column " + name);
  Signal signal;
  for (auto row = cells(); stream; row = cells())
    signal.time.push_back(std::stod(row[0])), signal.value.push_back(std::stod(row[at]));
  return signal;
}

std::filesystem::path CaseRun::geometry(const std::string& shape_and_options) const {
  const Outcome outcome = ostium("geometry " + shape_and_options + " -o vessel.stl");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  return folder() / "vessel.stl";
}

double CaseRun::noted(const std::string& what, double value) {
  std::printf("%s: %.4g\n", what.c_str(), value);
  return value;
}

void CaseRun::run(const std::string& name, const std::string& options) {
  const Outcome outcome = ostium("run '" + case_file(name).string() + "' -q -o results " + options);
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  for (const char* file : {"case.effective.yaml", "network.csv", "summary.json", "log.txt"})
    EXPECT_TRUE(exists(std::string("results/") + file)) << file;
  EXPECT_EQ(summary()["status"], "finished");
  EXPECT_EQ(summary()["case"], name);
  if (exists("results/ports.csv")) expect_vessel_results();
}

void CaseRun::expect_vessel_results() const {
  const auto facts = summary();
  EXPECT_TRUE(exists("results/balance.csv"));
  const auto balance = folder() / "results/balance.csv";
  const Signal volume = column(balance, "volume_inside_m3"), gap = column(balance, "discrepancy_m3");
  EXPECT_LE(std::max(gap.max(), -gap.min()),
            1e-10 * volume.max());  // inflows of short runs are tiny
  EXPECT_EQ(facts["escaped_particles"].get<int>(), 0);
  EXPECT_GT(facts["acoustic_steps"].get<long>(), 0);
  EXPECT_LT(facts["max_density_error"].get<double>(), 0.1);
  double phases = 0, bounds = 0;
  for (const auto& seconds : facts["phases_s"]) phases += seconds.get<double>();
  EXPECT_NEAR(phases, facts["wall_time_s"].get<double>(), 0.02 * phases + 0.02);
  for (const auto& share : facts["step_bounds"]) bounds += share.get<double>();
  EXPECT_NEAR(bounds, 1, 1e-12);
  ASSERT_EQ(facts["checks"].size(), 4u);
  EXPECT_TRUE(facts["checks"][0]["passed"].get<bool>()) << facts["checks"];  // mass balance
  EXPECT_TRUE(facts["checks"][1]["passed"].get<bool>()) << facts["checks"];  // nobody escaped
  for (const auto& [port, signals] : ports())
    for (const double p : signals.pressure.value) ASSERT_TRUE(std::isfinite(p)) << port;
}

}  // namespace ostium::test
