#include "app/results/account.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ostium::app {
namespace {

using Phases = std::vector<std::pair<const char*, double>>;

Phases phases_of(const Account& a, double wall) {
  const auto& v = a.vessel;
  const double known = v.acoustic + v.advection + v.walls + v.openings() + a.network + a.output;
  return {{"acoustic", v.acoustic},
          {"advection", v.advection},
          {"walls", v.walls},
          {"openings", v.openings()},
          {"network", a.network},
          {"output", a.output},
          {"other", std::max(wall - known, 0.0)}};
}

}  // namespace

void Account::add(const sph3d::StepReport& step) {
  vessel += step.seconds;
  ++bounds[static_cast<std::size_t>(step.bound)];
  particle_steps += static_cast<double>(step.particles) * step.acoustic_steps;
  max_speed = std::max(max_speed, step.max_speed);
  max_density_error = std::max(max_density_error, step.max_density_error);
}

double Account::balance(double inside, double in, double out) {
  const double gap = inside - volume_at_start - in + out;
  discrepancy = std::max(discrepancy, std::abs(gap));
  inflow = std::max(inflow, std::abs(in));
  return gap;
}

void archive(Archive& a, Account& account) {
  std::vector<std::int64_t> bounds(account.bounds.begin(), account.bounds.end());
  a("acoustic", account.vessel.acoustic);
  a("driving", account.vessel.driving);
  a("advection", account.vessel.advection);
  a("walls", account.vessel.walls);
  a("renewal", account.vessel.renewal);
  a("network", account.network);
  a("output", account.output);
  a("wall", account.wall);
  a("bounds", bounds);
  a("particle_steps", account.particle_steps);
  a("max_speed", account.max_speed);
  a("max_density_error", account.max_density_error);
  a("volume_at_start", account.volume_at_start);
  a("inflow", account.inflow);
  a("discrepancy", account.discrepancy);
  if (bounds.size() != account.bounds.size())
    a.misfit("bounds",
             fmt::format("{} kinds of step, this program has {}", bounds.size(), account.bounds.size()));
  std::copy(bounds.begin(), bounds.end(), account.bounds.begin());
}

std::vector<Check> checks_of(const Account& a, double sound_speed, std::int64_t escaped) {
  return {{"mass balance", a.discrepancy / std::max(a.inflow, a.volume_at_start), 1e-10},
          {"escaped particles", static_cast<double>(escaped), 0},
          {"largest density error", a.max_density_error, 0.03},
          {"largest speed over sound speed", a.max_speed / sound_speed, 0.15}};
}

nlohmann::json phases_json(const Account& account, double wall) {
  nlohmann::json json;
  for (const auto& [name, seconds] : phases_of(account, wall)) json[name] = seconds;
  return json;
}

nlohmann::json bounds_json(const Account& account) {
  double steps = 0;
  for (const auto n : account.bounds) steps += static_cast<double>(n);
  nlohmann::json json = nlohmann::json::object();
  for (int b = 1; b < sph3d::step_bounds; ++b)
    json[name(static_cast<sph3d::StepBound>(b))] =
        static_cast<double>(account.bounds[b]) / std::max(steps, 1.0);
  return json;
}

nlohmann::json checks_json(const std::vector<Check>& checks) {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& c : checks)
    json.push_back({{"name", c.name}, {"value", c.value}, {"allowed", c.allowed}, {"passed", c.passed()}});
  return json;
}

std::string phases_line(const Account& account, double wall, int threads) {
  std::string line = fmt::format("{:.3g} s:", wall);
  for (const auto& [name, seconds] : phases_of(account, wall))
    line += fmt::format(" {} {:.0f} %,", name, 100 * seconds / std::max(wall, 1e-9));
  return line + fmt::format(" {:.3g} particle-steps per second and core",
                            account.particle_steps / std::max(wall, 1e-9) / threads);
}

}  // namespace ostium::app
