// Shells made on vessels under load: an irregular cloud against exact tubes; a restart to the bit.
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "shell_clouds.hpp"
#include "sph3d/shell/archive.hpp"
#include "sph3d/shell/equilibrium.hpp"
#include "sph3d/shell/stable_step.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

struct Growth {
  double mean = 0, spread = 0;  // radial displacement over the exact one in the middle half: mean, deviation
};

/// A tube and its exact growth under a pressure p on the inner face: u = p R_i R/(E t) for free ends, less by
/// nu^2 where ends do not move along the axis, by nu R_i/(2 R) where the force on caps draws the tube.
struct Pressurised {
  Carotid tube{.length = 18e-3};
  double E = 1e6, nu = 0.45, p = 100;

  /// Tissue around, over the stiffness of the hoops: the loads of an irregular cloud do not cancel to the last digit, and
  /// without it the tube would drift away.
  static constexpr double give = 1e-3;

  double exact(WallEnds ends, bool capped) const {
    const double u = p * tube.radius * tube.middle() / (E * tube.thickness * (1 + give));
    return u * (capped                       ? 1 - 0.5 * nu * tube.radius / tube.middle()
                : ends == WallEnds::released ? 1 - nu * nu
                                             : 1);
  }

  Growth growth(WallEnds ends, bool capped) const {
    const auto shell = shell_of(tube.lumen(), tube.options(ends));
    auto options = static_options(tube.spacing, E, nu);
    options.face = -1;
    options.spring = give * E * tube.thickness / std::pow(tube.middle(), 2);
    const ShellModel<3> model(shell.cloud, options);
    EXPECT_EQ(model.guarded, 0u);
    auto load = no_load(model);
    for (auto& block : load)
      for (double& x : block.pressure) x = p;
    if (capped) draw(shell, load);
    auto state = rest(model);
    find_equilibrium(model, state, load, {.tolerance = 1e-4});
    return measure(model, state, exact(ends, capped));
  }

  /// The force of the pressure on caps, spread over the last rows.
  void draw(const WallShell<3>& shell, std::vector<ShellLoad<3>>& load) const {
    for (int k = 0; k < 2; ++k) {
      double area = 0;
      for (std::size_t a = 0; a < shell.count(); ++a)
        if (shell.opening[a] == k) area += shell.cloud.area[a];
      const double pull = p * pi * tube.radius * tube.radius / area;
      for (std::size_t a = 0; a < shell.count(); ++a)
        if (shell.opening[a] == k) set_force<3>(load, a, pull * shell.cloud.area[a] * shell.cloud.axis[a]);
    }
  }

  Growth measure(const ShellModel<3>& model, const ShellState<3>& state, double exact) const {
    const auto drift = rigid_motion(model, state);
    double sum = 0, squares = 0, n = 0;
    for (std::size_t a = 0; a < model.count(); ++a) {
      const Vec3 x = model.cloud.position[a];
      if (std::abs(x[2] - tube.length / 2) > tube.length / 4) continue;
      const double u = (state.displacement(a) - moves(x) * drift).dot(model.cloud.normal[a]) / exact;
      sum += u, squares += u * u, n += 1;
    }
    return {sum / n, std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0))};
  }

  using Rigid = Eigen::Matrix<double, 6, 1>;

  /// What unit translations and rotations do to a point.
  static Eigen::Matrix<double, 3, 6> moves(const Vec3& x) {
    Eigen::Matrix<double, 3, 6> m = Eigen::Matrix<double, 3, 6>::Zero();
    m.leftCols<3>().setIdentity();
    for (int d = 0; d < 3; ++d) m.col(3 + d) = Vec3::Unit(d).cross(x);
    return m;
  }

  /// The part of the displacement that only the weak tissue holds, by least squares.
  static Rigid rigid_motion(const ShellModel<3>& model, const ShellState<3>& state) {
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Rigid side = Rigid::Zero();
    for (std::size_t a = 0; a < model.count(); ++a) {
      const auto m = moves(model.cloud.position[a]);
      matrix += model.cloud.area[a] * m.transpose() * m;
      side += model.cloud.area[a] * m.transpose() * state.displacement(a);
    }
    return matrix.ldlt().solve(side);
  }
};

TEST(ShellGenerated, CylinderUnderPressureWithThreeEnds) {
  const Pressurised tube;
  for (const auto& [ends, capped] :
       {std::pair{WallEnds::free, false}, {WallEnds::released, false}, {WallEnds::free, true}}) {
    const Growth u = tube.growth(ends, capped);
    SCOPED_TRACE(testing::Message() << u.mean << " +- " << u.spread);
    EXPECT_NEAR(u.mean, 1.0, 0.01) << int(ends) << capped;
    if (ends == WallEnds::free && !capped) {
      EXPECT_LT(u.spread, 0.03);  // a free tube is easily made oval, by the unevenness of the loads
    }
  }
}

/// Keeps arrays in memory.
class Kept : public Archive {
 public:
  bool reading() const override { return reading_; }
  void misfit(const std::string& name, const std::string& problem) const override {
    throw std::runtime_error(name + problem);
  }
  void read_from_now_on() { reading_ = true; }

 protected:
  void array(const std::string& name, Kind, std::size_t records, std::size_t per_record,
             const Place& place) override {
    auto& bytes = arrays_[name];
    if (!reading_) bytes = {records, std::vector<char>(records * per_record * sizeof(double))};
    void* numbers = place(bytes.first);
    if (reading_)
      std::memcpy(numbers, bytes.second.data(), bytes.second.size());
    else
      std::memcpy(bytes.second.data(), numbers, bytes.second.size());
  }
  void enter(const std::string&) override {}
  void leave() override {}

 private:
  bool reading_ = false;
  std::map<std::string, std::pair<std::size_t, std::vector<char>>> arrays_;
};

template <int D>
void expect_same(const ShellState<D>& a, const ShellState<D>& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.strain_time, b.strain_time);
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  EXPECT_EQ(std::memcmp(a.blocks.data(), b.blocks.data(), a.blocks.size() * sizeof(ShellBlock<D>)), 0);
}

TEST(ShellGenerated, RestartIsExact) {
  const Carotid tube{.length = 9e-3};
  const ShellModel<3> model(shell_of(tube.lumen(), tube.options(WallEnds::clamped)).cloud,
                            {.spacing = tube.spacing});
  auto load = no_load(model);
  for (auto& block : load)
    for (double& x : block.pressure) x = 1000;
  const ShellSteps steps{stable_step(model), 20};
  auto state = rest(model);
  ShellWorkspace<3> work(model);
  advance(model, state, load, work, steps);
  Kept kept;
  archive(kept, state);
  advance(model, state, load, work, steps);
  kept.read_from_now_on();
  ShellState<3> again;
  archive(kept, again);
  ShellWorkspace<3> fresh(model);
  advance(model, again, load, fresh, steps);
  expect_same(state, again);
  EXPECT_GT(state.displacement(model.count() / 2).norm(), 0.0);
}

}  // namespace
}  // namespace ostium::sph3d
