// Walls of full thickness that move with the blood.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/fields/structure_fields.hpp"
#include "sph3d/solid/solid_report.hpp"
#include "sph3d/solid/solid_wall.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

constexpr double height = 0.010, length = 0.040, dp = 1e-3, pressure = 2000, thickness = 4e-3, spacing = 5e-4,
                 rho = 1000;

/// A channel of blood whose walls are so soft that they give way by what is easily seen, on a bed that is not.
struct ChannelOnCushions {
  static constexpr double E = 1e5, nu = 0.3;
  Vessel<2> vessel;

  explicit ChannelOnCushions(bool rigid = false) : vessel(empty()) { add_wall(rigid); }
  explicit ChannelOnCushions(SavedVessel<2> saved)
      : vessel(channel(length, height), options(), {{}, {}}, std::move(saved)) {
    add_wall(false);
  }

  static FluidOptions<2> options() {
    return {.dp = dp, .density = rho, .viscosity = 1e-5, .sound_speed = 10, .reference_speed = 0.3};
  }
  static Vessel<2> empty() { return {channel(length, height), options(), {{}, {}}, pressure}; }

  /// The outermost layer is held.
  void add_wall(bool rigid) {
    auto wall =
        solid_of(channel(length, height), {.spacing = spacing, .fluid_spacing = dp, .thickness = thickness});
    for (std::size_t b = 0; b < wall.layer.size(); ++b)
      if (rigid || wall.layer[b] == 7) wall.solid.held[b] = hold_all;
    const SolidOptions tissue{.material = SaintVenantKirchhoff({.E = E, .nu = nu}),
                              .density = rho,
                              .spacing = spacing,
                              .damping = 1.0};
    vessel.set_wall(std::make_unique<DeformableWall<2>>(SolidBody<2>(wall, tissue), vessel.model().reach(),
                                                        SurroundingsOfWall{}));
  }

  void advance() { advance(vessel); }
  static void advance(Vessel<2>& vessel) {
    std::vector<Drive> drives(2);
    for (auto& drive : drives)
      drive.law = {.p_star = pressure, .resistance = 4e5};  // about that of its waves
    vessel.advance(1, drives, 0.01);
  }

  const SolidBody<2>& body() const { return std::get<SolidBody<2>>(vessel.wall()->body()); }

  /// Of the inner surface against layer k, outward; mean over the middle of both walls.
  double compression(int layer) const {
    const auto& wall = body().wall();
    const auto& solid = vessel.state().wall.solid;
    const auto now = vessel.wall()->points(vessel.state().wall);
    double surface = 0, inside = 0;
    int n = 0, m = 0;
    for (std::size_t k = 0; k < wall.contact.size(); ++k)
      if (std::abs(wall.contact[k][0] - length / 2) < 5.1 * dp)
        surface += (now[k].position - wall.contact[k]).dot(body().reference_normals()[k]), ++n;
    for (std::size_t b = 0; b < wall.layer.size(); ++b)
      if (wall.layer[b] == layer && std::abs(wall.solid.position[b][0] - length / 2) < 5.1 * dp)
        inside += solid.displacement[b].dot(wall.normal[b]), ++m;
    return surface / n - inside / m;
  }

  /// Force of the blood on the middle of both walls over their area.
  double load() const {
    double sum = 0, area = 0;
    for (std::size_t k = 0; k < body().count(); ++k)
      if (std::abs(body().wall().contact[k][0] - length / 2) < 5.1 * dp)
        sum += vessel.wall()->forces()[k].dot(body().reference_normals()[k]),
            area += body().wall().inner.area[k].norm();
    return sum / area;
  }
};

/// Plane strain without any strain along the wall: p = - lambda M (lambda^2 - 1) / 2 in the reference.
double stretch_under(double p, double M) {
  double stretch = 1;
  for (int k = 0; k < 100; ++k) stretch = std::sqrt(1 - 2 * p / (M * stretch));
  return stretch;
}

TEST(MovingSolidWalls, CushionsGiveWayByTheirModulus) {
  ChannelOnCushions channel;
  while (channel.vessel.time() < 0.03) channel.advance();
  double found = 0, load = 0;
  int n = 0;
  for (; channel.vessel.time() < 0.06; ++n) {
    channel.advance();
    found += channel.compression(4), load += channel.load();
  }
  found /= n, load /= n;
  const double M = Moduli{ChannelOnCushions::E, ChannelOnCushions::nu}.p_wave(),
               exact = 4.5 * spacing * (1 - stretch_under(load, M));
  RecordProperty("compression_over_exact", std::to_string(found / exact));
  EXPECT_NEAR(found, exact, 0.02 * exact);
  EXPECT_NEAR(load, pressure, 0.06 * pressure);  // the openings hold their pressure to 0.1 % of rho c^2
  EXPECT_EQ(channel.vessel.state().escaped, 0);
}

/// A wall all of whose particles are held is the rigid wall, by another way.
TEST(MovingSolidWalls, HeldWallsAreRigid) {
  ChannelOnCushions held(true);
  Vessel<2> rigid = ChannelOnCushions::empty();
  auto state = rigid.save();
  state.reference_content = 0;  // where a wall could move, the content does not scale the kernel sums
  rigid.load(std::move(state));
  for (int k = 0; k < 10; ++k) held.advance(), ChannelOnCushions::advance(rigid);
  const auto &a = held.vessel.state().fluid, &b = rigid.state().fluid;
  ASSERT_EQ(a.places(), b.places());
  double apart = 0;
  for (std::size_t i = 0; i < a.places(); ++i)
    if (a.filled[i]) apart = std::max(apart, (a.position[i] - b.position[i]).norm());
  EXPECT_LT(apart, 1e-4 * dp);
}

TEST(MovingSolidWalls, ARestartIsExact) {
  ChannelOnCushions channel;
  for (int k = 0; k < 20; ++k) channel.advance();
  ChannelOnCushions again(channel.vessel.saved());
  for (int k = 0; k < 20; ++k) channel.advance(), again.advance();
  EXPECT_TRUE(same_bits(channel.vessel.state().fluid, again.vessel.state().fluid));
  EXPECT_EQ(channel.vessel.state().wall.solid.displacement, again.vessel.state().wall.solid.displacement);
}

/// Work of forces on the contact points is energy of the wall, whatever layers share the force.
TEST(MovingSolidWalls, WhatTheBloodGivesTheWallTakes) {
  const auto wall =
      solid_of(channel(length, height), {.spacing = spacing, .fluid_spacing = dp, .thickness = thickness});
  SolidBody<2> body(
      wall, {.material = SaintVenantKirchhoff({.E = 1e5, .nu = 0.3}), .density = rho, .spacing = spacing});
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  std::vector<Vec2> force;
  for (std::size_t k = 0; k < body.count(); ++k) force.emplace_back(any(random), any(random));
  auto state = body.at_rest();
  const auto before = body.contacts(state);
  body.step(state, 2e-8, force, 0.0);  // before its own forces matter
  const auto after = body.contacts(state);
  double work = 0;
  for (std::size_t k = 0; k < body.count(); ++k) work += force[k].dot(after[k] - before[k]);
  EXPECT_NEAR(energy(body.model(), state).total(), work, 1e-6 * work);
}

/// What the blood does not carry of its pressure acts on the present surface: a thick cylinder in plane strain, against Lame.
TEST(MovingSolidWalls, RingUnderTheReferencePressureIsLames) {
  constexpr double R = 0.01, t = 0.005, E = 1e6, nu = 0.3, p = 400, outside = 700, ramp = 0.03;
  Lumen<2> circle;
  for (int k = 0; k < 400; ++k) {
    circle.surface.points.push_back(R * Vec2(std::cos(2 * pi * k / 400), std::sin(2 * pi * k / 400)));
    circle.surface.facets.push_back({k, (k + 1) % 400});
    circle.surface.label.push_back(-1);
  }
  DeformableWall<2> vessel(SolidBody<2>(wall_cloud(circle, t, t / 8),
                                        {.material = NeoHookean({E, nu}), .density = rho, .spacing = t / 8}),
                           1e-3, {.outside_pressure = outside, .rest_pressure = outside, .ramp = ramp});
  auto state = vessel.rest(p + outside);
  vessel.attach(state, FluidState<2>{});
  const auto rest = vessel.points_at_rest();
  double widening = 0, growth = 0;
  int n = 0;
  while (state.solid.time < ramp + 0.01) {
    vessel.step(state, 1e-4, p + outside);
    if (state.solid.time < ramp) continue;
    const auto now = vessel.points(state);
    for (std::size_t k = 0; k < now.size(); ++k, ++n)
      widening += now[k].position.norm() - rest[k].position.norm(), growth += now[k].area / rest[k].area - 1;
  }
  const double outer = R + t, A = p * R * R / (outer * outer - R * R);
  const auto displacement = [&](double r) {
    return A * (1 + nu) / E * ((1 - 2 * nu) * r + outer * outer / r);
  };
  const double exact = displacement(R), first_layer = R + t / 16;
  EXPECT_NEAR(widening / n, exact, 0.01 * exact);
  EXPECT_NEAR(growth / n, displacement(first_layer) / first_layer,
              0.02 * exact / R);  // F is that of the layer

  const auto fields = structure_fields(vessel, state);
  const auto mean = [](const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum += x;
    return sum / static_cast<double>(v.size());
  };
  const auto von_mises_at = [&](double r) {
    const double q = outer * outer / (r * r);
    return von_mises<double>({.xx = A * (1 - q), .yy = A * (1 + q), .zz = 2 * nu * A});
  };
  EXPECT_NEAR(mean(fields.inner.von_mises), von_mises_at(R + t / 16), 0.05 * von_mises_at(R));
  EXPECT_NEAR(mean(fields.middle.von_mises), von_mises_at(R + 9 * t / 16), 0.05 * von_mises_at(R));
  EXPECT_NEAR(mean(fields.outer.von_mises), von_mises_at(outer - t / 16), 0.05 * von_mises_at(R));
  // half of the work of the pressure, per area
  EXPECT_NEAR(mean(fields.energy), 0.5 * p * exact, 0.03 * p * exact);
}

TEST(MovingSolidWalls, WhatIsRefused) {
  const auto refused = [](const SolidWallOptions& o) {
    try {
      solid_of(channel(length, height), o);
    } catch (const UserError& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refused({.spacing = 2e-3, .fluid_spacing = 1e-3, .thickness = 1e-2}),
              testing::HasSubstr("coarser than the fluid's"));
  EXPECT_THAT(refused({.spacing = 1e-3, .fluid_spacing = 1e-3, .thickness = 2e-3}),
              testing::HasSubstr("four layers of particles or more"));
  EXPECT_THAT(refused({.spacing = 1e-3, .fluid_spacing = 1e-3, .thickness = 4e-3, .clamp_length = 2e-3}),
              testing::HasSubstr("less than three rows of particles"));
  EXPECT_THAT(refused({.spacing = 1e-3, .fluid_spacing = 1e-3, .thickness = 4e-3, .clamp_length = 0.03}),
              testing::HasSubstr("hold all of it"));
}

}  // namespace
}  // namespace ostium::sph3d
