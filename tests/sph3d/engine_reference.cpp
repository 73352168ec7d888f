// The fluid kernels against the plain double-precision reference, on a moving disordered fluid with walls and openings.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "bench/plain_reference.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

template <int D>
Lumen<D> vessel_lumen() {
  if constexpr (D == 2)
    return channel(0.03, 0.01);
  else
    return tube(0.005, 0.012);
}

template <int D>
struct Prepared {
  Vessel<D> vessel;
  FluidState<D> fluid;
  Workspace<D> work;

  explicit Prepared(const Lumen<D>& lumen = vessel_lumen<D>())
      : vessel(lumen,
               {.dp = 1e-3, .density = 1000, .viscosity = 1e-4, .sound_speed = 10, .reference_speed = 1},
               {{}, {}}, 500.0),
        fluid(vessel.state().fluid) {
    for (std::size_t i = 0; i < fluid.places(); ++i) {
      if (!fluid.filled[i]) continue;
      for (int d = 0; d < D; ++d)
        fluid.clusters[i / 8].v[d][i % 8] = static_cast<float>(
            std::sin(900.0 * fluid.position[i][d] + 3.0 * d + 700.0 * fluid.position[i][(d + 1) % D]));
      fluid.psi(i) += static_cast<float>(2e-3 * std::cos(1200.0 * fluid.position[i].sum()));
    }
    const auto& model = vessel.model();
    freeze(model, fluid, work);
    find_zones(model, fluid, work);
    look_around(model, fluid, work);
    kernel_sums(model, fluid, work);
  }
};

/// Largest difference over the rms of the reference.
struct Error {
  double largest = 0, square = 0;
  int n = 0;
  void add(double difference, double reference) {
    largest = std::max(largest, std::abs(difference));
    square += reference * reference;
    ++n;
  }
  double relative() const { return largest / std::sqrt(square / n); }
};

/// B and the friction rate of one particle in double, from its moments.
template <int D>
std::pair<Mat<D>, double> plain_correction(const Model<D>& model, const Cluster<D>& own, Mat<D> M,
                                           const ClusterSurroundings<D>& around, std::size_t lane) {
  const Vec<D> flux = lane_vector<D>(own.wall, lane);
  const HalfSpace<D>& space = model.half_space;
  if (flux.norm() == 0) {
    const double det = M.determinant(), weight = std::min(2 * det, 1.0);
    return {weight * M.inverse() + (1 - weight) * Mat<D>::Identity(), 0.0};
  }
  const Vec<D> n = flux.normalized();
  const double s = space.distance(around.filling[lane]);
  const double ratio = model.density_ratio(own.psi[lane]);
  M += ratio *
       (space.moment_n(s) * n * n.transpose() + space.moment_t(s) * (Mat<D>::Identity() - n * n.transpose()));
  const double weight = std::min(2 * M.determinant(), 1.0);
  const Mat<D> B = weight * M.inverse() + (1 - weight) * Mat<D>::Identity();
  const double nBn = n.dot(B * n);
  return {B, ratio * model.options.viscosity *
                 (space.friction_n(s) * nBn + space.friction_t(s) * (B.trace() - nBn))};
}

template <int D>
void compare(const char* isa) {
  setenv("OSTIUM_ISA", isa, 1);
  Prepared<D> p;
  const auto& model = p.vessel.model();
  plain::Fluid<D> reference(model, p.fluid);
  reference.sums();
  Error density, gradient, moment, k0, G, viscous, velocity, rate, diss, psi;
  const auto all = [&](auto&& f) {
    for (std::size_t i = 0; i < p.fluid.places(); ++i)
      if (p.fluid.filled[i]) f(i, i / 8, i % 8, reference.particles[i]);
  };
  all([&](std::size_t, std::size_t c, std::size_t lane, const auto& r) {
    density.add(p.work.sums[c].density[lane] - r.density, r.density);
    k0.add(p.fluid.clusters[c].k0[lane] - r.k0, r.k0);
    for (int d = 0; d < D; ++d) gradient.add(p.work.sums[c].gradient[d][lane] - r.gradient[d], r.k0);
    const Mat<D> m = lane_matrix<D>(p.work.sums[c].moment, lane);
    moment.add((m - r.moment).norm(), r.moment.norm());
  });
  correct(model, p.fluid, p.work, 1e9, 0);  // no source: the reference has none
  Error matrix, friction;
  all([&](std::size_t, std::size_t c, std::size_t lane, const auto&) {
    const auto [B, rate] = plain_correction<D>(
        model, p.fluid.clusters[c], lane_matrix<D>(p.work.sums[c].moment, lane), p.work.around[c], lane);
    matrix.add((lane_matrix<D>(p.fluid.clusters[c].B, lane) - B).norm(), B.norm());
    friction.add(p.fluid.clusters[c].friction[lane] - rate, rate);
  });
  EXPECT_LT(matrix.relative(), 1e-4);
  EXPECT_LT(friction.relative(), 1e-4);
  prepare_forces(model, p.fluid, p.work);
  reference = plain::Fluid<D>(model, p.fluid);
  reference.corrected_sums();
  all([&](std::size_t, std::size_t c, std::size_t lane, const auto& r) {
    for (int d = 0; d < D; ++d) {
      G.add(p.fluid.clusters[c].G[d][lane] - r.G[d], 1.0 / model.kernel.h);
      viscous.add(p.fluid.clusters[c].prior[d][lane] - r.viscous[d], r.viscous[d]);
    }
  });
  const FluidConstants constants = constants_of(model);
  const float dt = 2e-5f;
  const auto n = static_cast<std::int64_t>(p.fluid.clusters.size());
  for (std::size_t i = 0; i < p.fluid.places(); ++i)
    p.work.place[i].w = constants.kV * constants.c2 * p.fluid.psi(i) /
                        static_cast<float>(model.density_ratio(p.fluid.psi(i)));
  const auto before = reference.particles;
  fluid_kernels<D>().kick(0, n, p.fluid.clusters.data(), p.work.rows.data(), p.work.place.data(),
                          p.work.velocity.data(), nullptr, constants, dt);
  reference.kick(dt);
  all([&](std::size_t i, std::size_t c, std::size_t lane, const auto& r) {
    for (int d = 0; d < D; ++d)
      velocity.add(p.fluid.clusters[c].v[d][lane] - r.v[d], r.v[d] - before[i].v[d]);
    rate.add(p.fluid.clusters[c].rate[lane] - r.rate, r.rate);
  });
  fluid_kernels<D>().density(0, n, p.fluid.clusters.data(), p.work.rows.data(), p.work.place.data(),
                             p.work.velocity.data(), nullptr, constants, dt, 1.0f);
  reference.density(dt, 1.0);
  all([&](std::size_t i, std::size_t c, std::size_t lane, const auto& r) {
    psi.add(p.fluid.psi(i) - r.psi, r.psi - before[i].psi);
    for (int d = 0; d < D; ++d) diss.add(p.fluid.clusters[c].diss[d][lane] - r.diss[d], r.diss[d]);
  });
  const double bar = 1e-4;
  EXPECT_LT(density.relative(), bar);
  EXPECT_LT(gradient.relative(), bar);
  EXPECT_LT(moment.relative(), bar);
  EXPECT_LT(k0.relative(), bar);
  EXPECT_LT(G.relative(), bar);
  EXPECT_LT(viscous.relative(), bar);
  EXPECT_LT(velocity.relative(), 3 * bar);  // includes the rounding of the velocity itself
  EXPECT_LT(rate.relative(), 3 * bar);
  EXPECT_LT(psi.relative(), 3 * bar);
  EXPECT_LT(diss.relative(), 3 * bar);
  unsetenv("OSTIUM_ISA");
}

/// Largest difference over the largest value.
struct Largest {
  double difference = 0, value = 0;
  template <class V>
  void add(const V& difference_of, const V& value_of) {
    difference = std::max(difference, size(difference_of)), value = std::max(value, size(value_of));
  }
  double relative() const { return difference / value; }

 private:
  static double size(double x) { return std::abs(x); }
  static double size(const Vec2& x) { return x.norm(); }
  static double size(const Vec3& x) { return x.norm(); }
};

/// A whole advection step, from frozen positions to new ones, by the engine's own functions and in double precision: sums,
/// corrections, corrected sums, acoustic steps, displacement with its shift. The wall is felt through the same table.
template <int D>
void compare_whole_step(const Lumen<D>& lumen, std::size_t least_particles) {
  constexpr int acoustic_steps = 5;
  const float dt = 4e-5f;
  Prepared<D> p(lumen);
  const auto& model = p.vessel.model();
  ASSERT_GE(p.fluid.count(), least_particles);
  plain::Fluid<D> reference(model, p.fluid);
  reference.sums();
  const std::vector<ClusterSums<D>> first_sums = p.work.sums;
  correct(model, p.fluid, p.work, 1e9, 0);  // no density source: the reference has none
  prepare_forces(model, p.fluid, p.work);

  const std::size_t places = p.fluid.places();
  std::vector<Vec<D>> moved(places, Vec<D>::Zero());
  std::vector<double> psi(places);
  for (std::size_t i = 0; i < places; ++i) {
    auto& r = reference.particles[i];
    const std::size_t c = i / 8, lane = i % 8;
    if (!p.fluid.filled[i]) continue;
    // what an outer face adds to the moments is the same for both
    const Mat<D> open =
        lane_matrix<D>(p.work.sums[c].moment, lane) - lane_matrix<D>(first_sums[c].moment, lane);
    std::tie(r.B, r.friction) =
        plain_correction<D>(model, p.fluid.clusters[c], r.moment + open, p.work.around[c], lane);
    r.along = p.fluid.clusters[c].along[lane];
    psi[i] = r.psi;
  }
  reference.corrected_sums();
  for (auto& r : reference.particles) r.prior = r.viscous;

  const auto& kernels = fluid_kernels<D>();
  const FluidConstants constants = constants_of(model);
  const auto n = static_cast<std::int64_t>(p.fluid.clusters.size());
  for (std::size_t i = 0; i < places; ++i)
    p.work.place[i].w = constants.kV * constants.c2 * p.fluid.psi(i) /
                        static_cast<float>(model.density_ratio(p.fluid.psi(i)));
  Largest acceleration, rate, wall_force;
  std::vector<Vec<D>> before(places);
  for (int k = 1; k <= acoustic_steps; ++k) {
    for (std::size_t i = 0; i < places; ++i) before[i] = reference.particles[i].v;
    std::vector<Vec<D>> engine_before(places);
    for (std::size_t i = 0; i < places; ++i) engine_before[i] = p.fluid.velocity(i);
    const float weight = k == acoustic_steps ? 0.5f : 1.0f;
    kernels.kick(0, n, p.fluid.clusters.data(), p.work.rows.data(), p.work.place.data(),
                 p.work.velocity.data(), nullptr, constants, dt);
    reference.kick(dt);
    kernels.density(0, n, p.fluid.clusters.data(), p.work.rows.data(), p.work.place.data(),
                    p.work.velocity.data(), nullptr, constants, dt, weight);
    reference.density(dt, weight);
    for (std::size_t i = 0; i < places; ++i) {
      if (!p.fluid.filled[i]) continue;
      const auto& r = reference.particles[i];
      const auto& own = p.fluid.clusters[i / 8];
      const std::size_t lane = i % 8;
      moved[i] += 0.5 * dt * (before[i] + r.v);
      const Vec<D> a = (r.v - before[i]) / dt, b = (p.fluid.velocity(i) - engine_before[i]) / dt;
      acceleration.add(Vec<D>(a - b), a);
      rate.add(r.rate - own.rate[lane], r.rate);
      const double c2 = constants.c2;
      const Vec<D> force = 2 * c2 * r.psi * plain::across_wall<D>(r.B, r.wall) + r.friction * r.v;
      const Vec<D> engine_force =
          2 * c2 * own.psi[lane] * plain::across_wall<D>(lane_matrix<D>(own.B, lane), r.wall) +
          own.friction[lane] * p.fluid.velocity(i);
      wall_force.add(Vec<D>(force - engine_force), force);
    }
  }
  Largest velocity, density, way;
  const double zeta_h2 = model.options.shift * model.kernel.h * model.kernel.h;
  for (std::size_t i = 0; i < places; ++i) {
    if (!p.fluid.filled[i]) continue;
    const auto& r = reference.particles[i];
    velocity.add(Vec<D>(p.fluid.velocity(i) - r.v), r.v);
    density.add(p.fluid.psi(i) - r.psi, r.psi - psi[i]);
    if (p.work.duct_of[i] >= 0) continue;  // the shift is another one there
    const Vec<D> there = moved[i] - zeta_h2 * r.imbalance;
    const Vec<D> engine = lane_vector<D>(p.fluid.clusters[i / 8].moved, i % 8) -
                          zeta_h2 * lane_vector<D>(p.work.sums[i / 8].imbalance, i % 8);
    way.add(Vec<D>(there - engine), there);
  }
  const std::vector<std::pair<const char*, const Largest*>> all{
      {"acceleration", &acceleration}, {"density rate", &rate}, {"wall force", &wall_force},
      {"velocity", &velocity},         {"density", &density},   {"displacement", &way}};
  for (const auto& [name, error] : all) {
    std::printf("%-14s largest error over largest value %.1e\n", name, error->relative());
    EXPECT_LT(error->relative(), 1e-4) << name;
  }
}

TEST(WholeAdvectionStep, AgreesWithThePlainReference2d) { compare_whole_step<2>(channel(0.03, 0.01), 300); }
TEST(WholeAdvectionStep, AgreesWithThePlainReference3d) { compare_whole_step<3>(tube(0.005, 0.012), 800); }
/// Local coordinates are long here: 300 particles from end to end.
TEST(FullWholeAdvectionStep, AgreesWithThePlainReferenceAt300000Particles) {
  compare_whole_step<3>(tube(0.018, 0.3), 300000);
}

TEST(FluidKernels, AgreeWithThePlainReference2d) { compare<2>(""); }
TEST(FluidKernels, AgreeWithThePlainReference3d) { compare<3>(""); }
TEST(FluidKernels, Avx2InstructionsAgreeWithThePlainReference2d) { compare<2>("avx2"); }
TEST(FluidKernels, Avx2InstructionsAgreeWithThePlainReference3d) { compare<3>("avx2"); }
TEST(FluidKernels, BaselineInstructionsAgreeWithThePlainReference2d) { compare<2>("baseline"); }
TEST(FluidKernels, BaselineInstructionsAgreeWithThePlainReference3d) { compare<3>("baseline"); }

}  // namespace
}  // namespace ostium::sph3d
