#include "app/calibration.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "sph3d/geometry/polygon.hpp"
#include "sph3d/particles/fill.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::app {
namespace {

using namespace sph3d;

constexpr double dp = 1e-3, speed = 0.5, density = 1060, sound_speed = 10 * speed;
constexpr double measuring_time = 0.4;  // s, with one thread and again with all of them
constexpr int warm_up = 2, at_least = 3;
constexpr int relaxed = 40;  // iterations: enough to leave the lattice, whose rows are shorter than a fluid's
template <int D>
constexpr int usual_iterations = D == 3 ? 200 : 1000;  // of a vessel that is to be at rest (particles/fill)

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(Now::now() - begin_).count(); }

 private:
  using Now = std::chrono::steady_clock;
  Now::time_point begin_ = Now::now();
};

/// The threads of the run, for as long as it lives.
class Threads {
 public:
  explicit Threads(int threads) : before_(omp_get_max_threads()) { omp_set_num_threads(threads); }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_;
};

/// A straight duct, square in 3D; opening 0 at z = 0 (2D: x = 0), 1 at the other end.
template <int D>
Lumen<D> small_duct();

template <>
Lumen<2> small_duct<2>() {
  const double length = 120 * dp, width = 40 * dp;
  const std::vector<Vec2> corners{{0, 0}, {length, 0}, {length, width}, {0, width}};
  const std::vector<OutlineOpening> openings{{.name = "in", .edge = 3}, {.name = "out", .edge = 1}};
  return polygon_lumen(corners, openings);
}

Opening<3> square(const std::vector<Vec3>& corners, const Vec3& normal, double area) {
  const Vec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  return {.centre = centre, .normal = normal, .area = area, .outline = corners};
}

template <>
Lumen<3> small_duct<3>() {
  const double length = 14 * dp, a = 6 * dp;  // half the width
  Surface<3> box;
  for (const double z : {0.0, length})
    for (const Vec2& p : {Vec2(-a, -a), Vec2(a, -a), Vec2(a, a), Vec2(-a, a)})
      box.points.emplace_back(p.x(), p.y(), z);
  const auto side = [&](int i, int j, int k, int l, int label) {
    box.facets.insert(box.facets.end(), {{i, j, k}, {i, k, l}});
    box.label.insert(box.label.end(), 2, label);
  };
  side(3, 2, 1, 0, 0), side(4, 5, 6, 7, 1);
  for (int k = 0; k < 4; ++k) side(k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4, -1);
  const auto& x = box.points;
  Lumen<3> lumen{.surface = box, .volume = 4 * a * a * length, .wall_area = 8 * a * length};
  lumen.openings = {square({x[3], x[2], x[1], x[0]}, -Vec3::UnitZ(), 4 * a * a),
                    square({x[4], x[5], x[6], x[7]}, Vec3::UnitZ(), 4 * a * a)};
  return lumen;
}

/// Seconds per particle of the fastest steps: those in which no other work of the machine held up a thread.
template <int D>
void measure_steps(Vessel<D>& vessel, Calibration& result) {
  std::vector<Drive> drives(2);
  const double area = vessel.model().ducts[0].opening().area;
  drives[0].flow_in = 0.5 * speed * area;
  drives[1].law.resistance = density * sound_speed / area;
  const Clock clock;
  for (int k = 0; k < warm_up + at_least || clock.seconds() < measuring_time; ++k) {
    const StepReport step = vessel.advance(1.0, drives, 0.01);
    if (k < warm_up) continue;
    const auto& s = step.seconds;
    const double n = static_cast<double>(step.particles);
    result.acoustic = std::min(result.acoustic, (s.acoustic + s.driving) / (n * step.acoustic_steps));
    result.advection = std::min(result.advection, (s.advection + s.walls + s.renewal) / n);
  }
}

}  // namespace

template <int D>
Calibration calibrate(int threads) {
  const FluidOptions<D> fluid{.dp = dp,
                              .density = density,
                              .viscosity = 4e-6,
                              .sound_speed = sound_speed,
                              .reference_speed = 0.5 * speed,
                              .density_relaxation = 0.2};
  const Lumen<D> duct = small_duct<D>();
  const Threads one(1);  // a brief piece of work on many threads would be measured by its waiting
  SavedVessel<D> empty{.state = {}, .number_density = lattice_sum(Wendland<D>{1.3 * dp}, dp)};
  empty.state.ports.resize(2);
  Calibration result;
  const Clock modelling;
  Vessel<D> vessel(duct, fluid, {{.flow_driven = true}, {}}, empty);
  result.modelling = modelling.seconds() * std::pow(dp, D - 1) / duct.wall_area / threads;
  const Clock filling;
  empty.state.fluid = fill(vessel.model(), {.iterations = relaxed});
  const double particles = static_cast<double>(empty.state.fluid.count()) * threads;
  result.filling = filling.seconds() * usual_iterations<D> / relaxed / particles;
  vessel.load(std::move(empty.state));
  result.acoustic = result.advection = std::numeric_limits<double>::infinity();
  measure_steps(vessel, result);
  const Threads all(threads);
  if (threads > 1) measure_steps(vessel, result);
  return result;
}

Calibration nominal_speed(int threads) {
  const double n = threads;
  return {.modelling = 6e-4 / n, .filling = 8e-5 / n, .acoustic = 1.7e-7 / n, .advection = 1e-6 / n};
}

template Calibration calibrate<2>(int);
template Calibration calibrate<3>(int);

}  // namespace ostium::app
