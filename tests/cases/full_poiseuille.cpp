// Developed flow in a channel and in a tube: profile, wall shear stress, pressure drop, order of convergence.
#include <algorithm>
#include <cmath>

#include "case_run.hpp"
#include "fields.hpp"

namespace ostium::test {
namespace {

constexpr double u_max = 0.0125, shear = 0.0125, width = 1e-3;  // m/s, Pa, m

/// Means over the middle part and over the last half of the run.
struct Developed {
  double peak = 0;   // m/s, of the parabola fitted to the particles
  double rms = 0;    // m/s, of the mean profile (ten layers from axis to wall) against the exact one
  double shear = 0;  // Pa, over the wall
  double drop = 0;   // Pa, between the openings
};

using Radius = double (*)(const std::array<double, 3>&);  // distance from the axis

class FullPoiseuille : public CaseRun {
 protected:
  Developed middle(int axis, double from, double to, Radius radius) const {
    const auto inside = [&](const std::array<double, 3>& x) { return x[axis] > from && x[axis] < to; };
    struct Layer {
      double n = 0, error = 0;
    };
    std::vector<Layer> layers(10);
    double ee = 0, ue = 0, area = 0, force = 0;
    for (const auto& file : last_files(folder() / "results/fields", "fluid_", 0.5)) {
      const PointFile fluid = read_points(file);
      for (std::size_t i = 0; i < fluid.points.size(); ++i) {
        if (!inside(fluid.points[i])) continue;
        const double xi = 2.0 * radius(fluid.points[i]) / width, exact = 1.0 - xi * xi;
        const double u = fluid.fields.at("velocity")[i][axis];
        ee += exact * exact, ue += u * exact;
        Layer& layer = layers[std::clamp(static_cast<int>(10 * xi), 0, 9)];
        ++layer.n, layer.error += u - u_max * exact;
      }
    }
    for (const auto& file : last_files(folder() / "results/fields", "wall_", 0.5)) {
      const PointFile wall = read_points(file);
      for (std::size_t i = 0; i < wall.points.size(); ++i) {
        if (!inside(wall.points[i])) continue;
        const double a = wall.fields.at("area")[i][0];
        area += a, force += a * wall.fields.at("wall_shear_stress")[i][axis];
      }
    }
    double squares = 0;
    for (const Layer& layer : layers) squares += std::pow(layer.error / std::max(layer.n, 1.0), 2) / 10;
    return {noted("peak, m/s", ue / ee), std::sqrt(squares), noted("wall shear stress, Pa", force / area),
            noted("pressure drop, Pa", drop())};
  }

  double drop() const {
    const auto all = ports();
    const Signal &in = all.at("inlet").pressure, &out = all.at("outlet").pressure;
    const double end = in.time.back();
    return in.between(end / 2, end).mean() - out.between(end / 2, end).mean();
  }

  /// Sampled often and long: sound stands between given flow and given pressure and swings the flow by 1-5 %.
  Developed channel(int across) {
    run("poiseuille_2d",
        "--force --threads 1 --set 'time.end=2 s' --set 'output.fields_every=7 ms' --set 'vessel.spacing=" +
            std::to_string(1.0 / across) + " mm'");
    return middle(0, 1e-3, 3e-3, [](const std::array<double, 3>& x) { return std::abs(x[1] - 0.5e-3); });
  }
};

TEST_F(FullPoiseuille, Channel30Across) {
  const Developed d = channel(30);
  EXPECT_NEAR(d.peak, u_max, 0.005 * u_max);
  EXPECT_LT(d.rms, 0.01 * u_max);
  EXPECT_NEAR(d.shear, shear, 0.03 * shear);
  EXPECT_NEAR(d.drop, 0.1, 0.05 * 0.1);
}

TEST_F(FullPoiseuille, ChannelConverges) {
  std::vector<double> error;
  for (const int across : {10, 20, 40}) {
    error.push_back(
        noted("rms of the profile, " + std::to_string(across) + " across", channel(across).rms / u_max));
  }
  EXPECT_GE(std::log2(error[0] / error[2]) / 2, 1.5) << error[0] << " " << error[1] << " " << error[2];
}

TEST_F(FullPoiseuille, Tube30Across) {
  const auto tube = geometry("tube --radius '0.5 mm' --length '2 mm'");
  run("poiseuille_3d", "--set 'output.fields_every=40 ms' --surface '" + tube.string() + "'");
  const Developed d =
      middle(2, 0.5e-3, 1.5e-3, [](const std::array<double, 3>& x) { return std::hypot(x[0], x[1]); });
  EXPECT_NEAR(d.peak, u_max, 0.01 * u_max);
  EXPECT_NEAR(d.shear, shear, 0.03 * shear);
  EXPECT_NEAR(d.drop, 0.1, 0.05 * 0.1);
}

}  // namespace
}  // namespace ostium::test
