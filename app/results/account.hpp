/// The account of a coupled run: where the time went, what bounded the steps, what must hold at the end.
///
///   phases      s of wall time: acoustic, advection, walls, openings (sph3d/step/phases), network, output, other
///   bounds      share of the advection steps whose length each bound has set
///   checks      mass balance     largest |discrepancy| over the volume that has entered or stands inside   <= 1e-10
///               escaped          particles lost through the wall                                           == 0
///               density          largest deviation from the rest density                                   <= 3 %
///               speed            largest velocity over the sound speed                                     <= 15 %
#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::app {

struct Account {
  sph3d::PhaseSeconds vessel;                               // s
  double network = 0, output = 0;                           // s
  double wall = 0;                                          // s, of the sittings before this one
  std::array<std::int64_t, sph3d::step_bounds> bounds{};    // steps
  double particle_steps = 0;                                // particles times acoustic steps
  double max_speed = 0, max_density_error = 0;              // m/s, -
  double volume_at_start = 0, inflow = 0, discrepancy = 0;  // m3; the last two: largest so far

  void add(const sph3d::StepReport& step);
  /// Takes a balance down: the volume inside and what has entered and left, m3; returns the discrepancy.
  double balance(double inside, double in, double out);
};

void archive(Archive& a, Account& account);

struct Check {
  std::string name;
  double value = 0, allowed = 0;
  bool passed() const { return value <= allowed; }
};

std::vector<Check> checks_of(const Account& account, double sound_speed, std::int64_t escaped);

/// wall: s, of the whole run.
nlohmann::json phases_json(const Account& account, double wall);
nlohmann::json bounds_json(const Account& account);
nlohmann::json checks_json(const std::vector<Check>& checks);
/// One line: shares of the phases and the speed per core.
std::string phases_line(const Account& account, double wall, int threads);

}  // namespace ostium::app
