#include "app/coupled.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/effective.hpp"
#include "app/fields_output.hpp"
#include "app/flow_scales.hpp"
#include "app/interrupt.hpp"
#include "app/results/account.hpp"
#include "app/results/recorder.hpp"
#include "app/vessel_setup.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"
#include "coupling/run.hpp"

namespace ostium::app {
namespace {

constexpr double mmHg = 133.322387415;

template <int D>
sph3d::FluidOptions<D> fluid_options(const Case& study, const FlowScales& scales) {
  const auto& n = study.numerics;
  return {.dp = study.vessel->spacing,
          .density = study.fluid.density,
          .viscosity = study.fluid.viscosity / study.fluid.density,
          .sound_speed = scales.sound_speed,
          .reference_speed = n.reference_speed.value_or(0.5 * scales.speed),
          .advection_cfl = n.advection_cfl,
          .acoustic_cfl = n.acoustic_cfl,
          .shift = n.shift,
          .limiter = n.limiter,
          .density_relaxation = n.density_relaxation};
}

coupling::SchemeKind scheme_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::held:
      return coupling::SchemeKind::held;
    case Scheme::extrapolated:
      return coupling::SchemeKind::extrapolated;
    case Scheme::modified_euler:
      return coupling::SchemeKind::modified_euler;
    default:
      return coupling::SchemeKind::linearised;
  }
}

coupling::CoupledOptions coupled_options(const Case& study, const FlowScales& scales) {
  const double exchange = study.coupling.exchange.value_or(0.0);
  return {.scheme = scheme_of(study.coupling.scheme),
          .exchange = exchange,
          .filter_time = study.coupling.filter_time.value_or(std::max(0.01, 5.0 * exchange)),
          .datum_time = study.coupling.datum_time.value_or(scales.datum_time),
          .ramp = std::max(0.01, 3.0 * scales.length / scales.sound_speed),
          .period = study.time.period.value_or(0.0),
          .background = scales.background,
          .force = study.coupling.force};
}

/// One run: the loop, what is written down on the way, and what is said at the end.
template <int D>
class Session {
 public:
  Session(const Case& study, const RunOptions& options, const Setup<D>& setup,
          const std::optional<network::Start>& start)
      : study_(study),
        options_(options),
        scales_(flow_scales(study, setup, start)),
        end_(study.time.final()),
        run_(setup.lumen, fluid_options<D>(study, scales_), setup.profiles,
             network::Network(setup.model, setup.ports), start, coupled_options(study, scales_)),
        recorder_(study, options.case_name, options.folder, effective_case(study, setup.model), names(setup)),
        fields_(options.folder.path(), run_.vessel().model(),
                study.output.fields_every.value_or(study.time.period.value_or(end_) / 10.0)),
        progress_({.end = end_, .period = study.time.period.value_or(0.0), .quiet = options.quiet}) {
    account_.volume_at_start = run_.volume_inside();
  }

  int go() {
    introduce();
    began_ = std::chrono::steady_clock::now();
    record({});
    try {
      while (run_.time() < end_ * (1.0 - 1e-12) && !interrupted()) advance();
    } catch (const NumericsError&) {
      recorder_.finish(Status::failed, facts());
      throw;
    }
    progress_.finish();
    const bool stopped = run_.time() < end_ * (1.0 - 1e-12);
    judge();
    recorder_.finish(stopped ? Status::interrupted : Status::finished, facts());
    conclude(stopped);
    return stopped ? exit_interrupted : exit_ok;
  }

 private:
  static Recorder::Names names(const Setup<D>& setup) {
    Recorder::Names names;
    for (const auto& port : setup.ports) names.ports.push_back(port.opening);
    const network::Network network(setup.model, setup.ports);
    names.series = network.series_names();
    return names;
  }

  void introduce() {
    const auto& model = run_.vessel().model();
    log::info(
        "{}: {} particles of {:.3g} mm, sound speed {:.3g} m/s for velocities up to {:.3g} m/s, {} kernels, "
        "{} threads",
        options_.case_name, run_.vessel().state().fluid.count(), 1e3 * model.options.dp, scales_.sound_speed,
        scales_.speed, sph3d::fluid_kernels<D>().name, omp_get_max_threads());
    log::info("{}", run_.stability().text());
    for (const auto& warning : run_.warnings()) log::warn("{}", warning);
  }

  void advance() {
    const auto report = run_.step(end_);
    account_.add(report);
    record(report);
    if (progress_.due()) {
      recorder_.flush();
      progress_.update(run_.time(), run_.vessel().state().acoustic_steps,
                       fmt::format("max {:.3g} m/s  {:.4g} mmHg", report.max_speed, mean_pressure() / mmHg));
    } else {
      progress_.update(run_.time(), run_.vessel().state().acoustic_steps, {});
    }
  }

  double mean_pressure() const {
    double sum = 0;
    for (int k = 0; k < run_.port_count(); ++k) sum += run_.port(k).pressure;
    return sum / run_.port_count();
  }

  void record(const sph3d::StepReport& report) {
    const sph3d::Stopwatch watch(account_.output);
    std::vector<PortRow> rows;
    double in = 0, out = 0;
    for (int k = 0; k < run_.port_count(); ++k) {
      const auto port = run_.port(k);
      rows.push_back({port.flow_out, port.pressure, port.volume_out});
      (run_.network().kind(k) == network::PortKind::flow ? in : out) += port.volume_out;
    }
    series_.resize(run_.network().series_names().size());
    run_.network().series(series_);
    recorder_.row(run_.time(), rows, series_);
    const double discrepancy = account_.balance(run_.volume_inside(), -in, out);
    recorder_.balance({.time = run_.time(),
                       .volume_inside = run_.volume_inside(),
                       .in = -in,
                       .out = out,
                       .discrepancy = discrepancy,
                       .kinetic_energy = report.kinetic_energy,
                       .max_density_error = report.max_density_error,
                       .escaped = run_.vessel().state().escaped,
                       .bound = name(report.bound)});
    fields_.write_if_due(run_.vessel());
  }

  double wall() const {
    return account_.wall + std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

  std::vector<Check> checks() const {
    return checks_of(account_, scales_.sound_speed, run_.vessel().state().escaped);
  }

  nlohmann::json facts() const {
    Account account = account_;
    account.network = run_.network_seconds();
    const auto& state = run_.vessel().state();
    const int threads = omp_get_max_threads();
    return {
        {"particles", state.fluid.count()},
        {"advection_steps", state.steps},
        {"acoustic_steps", state.acoustic_steps},
        {"exchanges", run_.exchanges()},
        {"threads", threads},
        {"kernels", sph3d::fluid_kernels<D>().name},
        {"wall_time_s", wall()},
        {"network_time_s", account.network},
        {"phases_s", phases_json(account, wall())},
        {"step_bounds", bounds_json(account)},
        {"particle_steps_per_second_per_core", account.particle_steps / std::max(wall(), 1e-9) / threads},
        {"sound_speed_m_s", scales_.sound_speed},
        {"max_speed_m_s", account.max_speed},
        {"max_density_error", account.max_density_error},
        {"fluid_storage_m3_Pa", run_.vessel().storage()},
        {"network_compliance_m3_Pa", run_.network().total_compliance()},
        {"mass_balance_relative_to_inflow", account.inflow > 0 ? account.discrepancy / account.inflow : 0.0},
        {"escaped_particles", state.escaped},
        {"particles_put_back_inside", state.mirrored},
        {"checks", checks_json(checks())}};
  }

  /// Says which checks have failed; before the summary is written, which holds all warnings.
  void judge() const {
    for (const auto& check : checks())
      if (!check.passed())
        log::warn("check failed: {} is {:.3g}, allowed is {:.3g}", check.name, check.value, check.allowed);
    if (account_.max_speed > 0.15 * scales_.sound_speed)
      log::warn(
          "the blood reached {:.3g} m/s, more than 15 % of the sound speed of {:.3g} m/s; set "
          "fluid.sound_speed to "
          "{:.3g} m/s for density variations below 1 %",
          account_.max_speed, scales_.sound_speed, 10 * account_.max_speed);
  }

  void conclude(bool stopped) {
    log::info("{}", recorder_.table());
    Account account = account_;
    account.network = run_.network_seconds();
    log::info("{}", phases_line(account, wall(), omp_get_max_threads()));
    if (stopped)
      log::info("interrupted at {:.4g} of {:.4g} s; what was reached is in {}", recorder_.reached(), end_,
                recorder_.folder().path().string());
    else
      log::info("results in {}", recorder_.folder().path().string());
  }

  const Case& study_;
  const RunOptions& options_;
  FlowScales scales_;
  double end_;
  coupling::CoupledRun<D> run_;
  Recorder recorder_;
  FieldsOutput<D> fields_;
  Progress progress_;
  Account account_;
  std::vector<double> series_;
  std::chrono::steady_clock::time_point began_;
};

template <int D>
int run(const Case& study, const RunOptions& options) {
  const Setup<D> setup = set_up<D>(study);
  // below some thousand particles a thread waits longer for the others than it works; results are the same
  constexpr double particles_per_thread = 2000;
  const double useful = std::ceil(particle_count(study, setup.lumen) / particles_per_thread);
  if (options.threads > 0)
    omp_set_num_threads(static_cast<int>(std::clamp<double>(useful, 1.0, options.threads)));
  const auto start = start_of(study, setup.model, setup.ports);
  return Session<D>(study, options, setup, start).go();
}

}  // namespace

int run_coupled(const Case& study, const RunOptions& options) {
  return study.vessel->dimension == 2 ? run<2>(study, options) : run<3>(study, options);
}

}  // namespace ostium::app
