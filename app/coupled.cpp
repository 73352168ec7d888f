#include "app/coupled.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/checkpoint/checkpoint.hpp"
#include "app/checkpoint/saved_run.hpp"
#include "app/coupled_options.hpp"
#include "app/effective.hpp"
#include "app/interrupt.hpp"
#include "app/vessel_setup.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"
#include "coupling/run.hpp"

namespace ostium::app {
namespace {

constexpr double mmHg = 133.322387415;

/// One run: the loop, what is written down on the way, and what is said at the end.
template <int D>
class Session {
 public:
  Session(const Case& study, const RunOptions& options, const Setup<D>& setup,
          const std::optional<network::Start>& start, const std::optional<SavedRun<D>>& saved)
      : study_(study),
        options_(options),
        key_(checkpoint_key(study, setup.model, setup.lumen)),
        scales_(flow_scales(study, setup, start)),
        end_(study.time.final()),
        run_(make_run(study, scales_, setup, start, saved, options.quiet)),
        recorder_(study, options.case_name, options.folder, effective_case(study, setup.model), names(setup),
                  saved ? std::optional(saved->recorded) : std::nullopt),
        output_(study, setup.probes, options.folder.path(), run_.vessel(), saved ? &saved->output : nullptr),
        progress_({.start = run_.time(),
                   .end = end_,
                   .period = study.time.period.value_or(0.0),
                   .quiet = options.quiet}),
        steps_before_(run_.vessel().state().acoustic_steps) {
    account_.volume_at_start = run_.volume_inside();
    if (saved) account_ = saved->account;
  }

  int go() {
    introduce();
    if (run_.vessel().state().steps == 0) record({});
    try {
      while (!done() && !interrupted()) advance();
    } catch (const NumericsError& e) {
      fail(e);
    }
    progress_.finish();
    judge();
    return done() ? finish() : stop();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static Recorder::Names names(const Setup<D>& setup) {
    Recorder::Names names;
    for (const auto& port : setup.ports) names.ports.push_back(port.opening);
    const network::Network network(setup.model, setup.ports);
    names.series = network.series_names();
    names.elements = elements_of(setup.model);
    return names;
  }

  static coupling::CoupledRun<D> make_run(const Case& study, const FlowScales& scales, const Setup<D>& setup,
                                          const std::optional<network::Start>& start,
                                          const std::optional<SavedRun<D>>& saved, bool quiet) {
    const auto fluid = fluid_options<D>(study, scales);
    auto options = coupled_options(study, scales);
    Progress filling({.end = 1, .quiet = quiet, .task = "filling the vessel"});
    options.progress = [&](double share) {
      if (interrupted()) throw Interrupted{};
      filling.update(share, 0);
    };
    network::Network network(setup.model, setup.ports);
    coupling::MakeWall<D> wall;
    if (setup.wall)
      wall = [&](const sph3d::Model<D>& model) {
        filling.finish();
        return make_wall(study, *setup.wall, model, start_ramp(scales), quiet);
      };
    if (saved) return {saved->run, setup.lumen, fluid, setup.profiles, std::move(network), options, wall};
    return {setup.lumen, fluid, setup.profiles, std::move(network), start, options, wall};
  }

  bool done() const { return run_.time() >= end_ * (1.0 - 1e-12); }

  void introduce() {
    if (options_.folder.resumes())
      log::info("the run goes on from {:.6g} s, step {}", run_.time(), run_.vessel().state().steps);
    const auto& model = run_.vessel().model();
    log::info(
        "{}: {} particles of {:.3g} mm, sound speed {:.3g} m/s for velocities up to {:.3g} m/s, {} kernels, "
        "{} threads",
        options_.case_name, run_.vessel().state().fluid.count(), 1e3 * model.options.dp, scales_.sound_speed,
        scales_.speed, sph3d::fluid_kernels<D>().name, omp_get_max_threads());
    if (moves(study_)) log::info("{}", wall_text(scales_.wall, scales_.sound_speed, *run_.vessel().wall()));
    log::info("{}", run_.stability().text());
    for (const auto& warning : run_.warnings()) log::warn("{}", warning);
  }

  void advance() {
    const auto report = run_.step(end_);
    account_.add(report);
    watch_tension();
    watch_leaks(report);
    record(report);
    keep(report);
    if (progress_.due()) {
      recorder_.flush();
      output_.flush();
      progress_.update(run_.time(), run_.vessel().state().acoustic_steps - steps_before_,
                       fmt::format("max {:.3g} m/s  {:.4g} mmHg", report.max_speed, mean_pressure() / mmHg));
    } else {
      progress_.update(run_.time(), run_.vessel().state().acoustic_steps - steps_before_, {});
    }
  }

  /// A healthy state now and then in memory, for the case that the next steps fail; a checkpoint when one is due.
  void keep(const sph3d::StepReport& report) {
    const sph3d::Stopwatch watch(account_.output);
    constexpr int interval = 100;  // steps
    const bool healthy = report.max_speed < 0.3 * scales_.sound_speed && report.max_density_error < 0.1;
    if (healthy && run_.vessel().state().steps % interval == 0) good_ = save();
    const double every = study_.output.checkpoint_every;
    if (every <= 0 || seconds_since(saved_) < every) return;
    write(save());
    saved_ = Clock::now();
  }

  SavedRun<D> save() {
    SavedRun<D> saved{run_.save(), recorder_.save(), account_, output_.save()};
    saved.account.wall = wall();
    return saved;
  }

  void write(SavedRun<D> saved) const {
    write_checkpoint(options_.folder.checkpoint(), key_, [&](Archive& a) { archive(a, saved); });
  }

  [[noreturn]] void fail(const NumericsError& error) {
    progress_.finish();
    recorder_.finish(Status::failed, facts());
    if (!good_) throw error;
    const double time = good_->time();
    write(std::move(*good_));
    numerics_error(
        "{}\nthe last sound state, of {:.6g} s, is saved; go on from there, with smaller steps: {} --set "
        "numerics.acoustic_cfl={:.2g} --set numerics.advection_cfl={:.2g}",
        error.what(), time, options_.resume_command(), 0.5 * study_.numerics.acoustic_cfl,
        0.5 * study_.numerics.advection_cfl);
  }

  int finish() {
    output_.finish();
    output_.judge(study_.vessel->spacing);
    recorder_.finish(Status::finished, facts());
    std::error_code ignored;
    std::filesystem::remove(options_.folder.checkpoint(), ignored);  // nothing to go on with
    conclude();
    log::info("results in {}", options_.folder.path().string());
    return exit_ok;
  }

  int stop() {
    write(save());
    recorder_.finish(Status::interrupted, facts());
    conclude();
    log::info("interrupted at {:.4g} of {:.4g} s; go on with: {}", run_.time(), end_,
              options_.resume_command());
    return exit_interrupted;
  }

  double mean_pressure() const {
    double sum = 0;
    for (int k = 0; k < run_.port_count(); ++k) sum += run_.port(k).pressure;
    return sum / run_.port_count();
  }

  /// Fluid below the background pressure is under tension, which particles bear badly; told once, beyond a density
  /// deviation of a thousandth, the fluid's own noise.
  void watch_tension() {
    const auto& state = run_.vessel().state();
    const double noise = 1e-3 * study_.fluid.density * scales_.sound_speed * scales_.sound_speed;
    for (int k = 0; k < run_.port_count() && !tension_told_; ++k) {
      if (run_.port(k).pressure >= state.datum.reference - noise) continue;
      log::warn(
          "at {:.4g} s the pressure at \"{}\" was {:.3g} Pa less than the background of {:.3g} Pa covers, "
          "and the "
          "fluid came under tension; choose a shorter coupling.datum_time than {:.3g} ms{}",
          run_.time(), run_.network().port(k).opening, state.datum.reference - run_.port(k).pressure,
          state.datum.background, 1e3 * state.datum.tau,
          study_.initial() == network::Initial::rest ? ", or start from the periodic state (network.initial)"
                                                     : "");
      tension_told_ = true;
    }
  }

  /// Told once with its place; all are counted.
  void watch_leaks(const sph3d::StepReport& report) {
    if (report.leaked == 0 || leak_told_) return;
    log::warn(
        "at {:.6g} s {} of the blood's particles went through the wall near ({:.4g}, {:.4g}, {:.4g}) m and "
        "were put back "
        "where they had been; more are counted in balance.csv. Smaller steps (numerics.acoustic_cfl) or a "
        "smaller "
        "vessel.spacing keep them inside",
        run_.time(), report.leaked, report.leak[0], report.leak[1], report.leak[2]);
    leak_told_ = true;
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
    output_.follow(run_.vessel());
  }

  static double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
  }
  double wall() const { return account_.wall + seconds_since(began_); }

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

  void conclude() const {
    Account account = account_;
    account.network = run_.network_seconds();
    log::info("{}", recorder_.table());
    log::info("{}", phases_line(account, wall(), omp_get_max_threads()));
  }

  const Case& study_;
  const RunOptions& options_;
  CheckpointKey key_;
  FlowScales scales_;
  double end_;
  coupling::CoupledRun<D> run_;
  Recorder recorder_;
  VesselOutput<D> output_;
  Progress progress_;
  std::int64_t steps_before_;
  Account account_;
  std::optional<SavedRun<D>> good_;
  bool tension_told_ = false, leak_told_ = false;
  std::vector<double> series_;
  Clock::time_point began_ = Clock::now(), saved_ = began_;
};

template <int D>
std::optional<SavedRun<D>> saved_run(const Case& study, const RunOptions& options, const Setup<D>& setup) {
  if (!options.folder.resumes()) return {};
  SavedRun<D> saved;
  read_checkpoint(options.folder.checkpoint(), checkpoint_key(study, setup.model, setup.lumen),
                  [&](Archive& a) { archive(a, saved); });
  return saved;
}

template <int D>
int run(const Case& study, const RunOptions& options) {
  const Setup<D> setup = set_up<D>(study);
  // below some thousand particles a thread waits longer for the others than it works; results are the same
  constexpr double particles_per_thread = 2000;
  const double useful = std::ceil(particle_count(study, setup.lumen) / particles_per_thread);
  if (options.threads > 0)
    omp_set_num_threads(static_cast<int>(std::clamp<double>(useful, 1.0, options.threads)));
  const auto saved = saved_run(study, options, setup);
  const auto start = start_of(study, setup.model, setup.ports);
  return Session<D>(study, options, setup, start, saved).go();
}

}  // namespace

int run_coupled(const Case& study, const RunOptions& options) {
  return study.vessel->dimension == 2 ? run<2>(study, options) : run<3>(study, options);
}

}  // namespace ostium::app
