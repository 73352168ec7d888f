// Developed flow in a channel and in a tube: profile, wall shear stress, pressure drop, order of convergence.
#include <cmath>

#include "case_run.hpp"
#include "fields.hpp"

namespace ostium::test {
namespace {

constexpr double u_max = 0.0125, shear = 0.0125, width = 1e-3;  // m/s, Pa, m

struct Developed {
  double peak = 0;      // m/s, of the parabola fitted to the middle part
  double rms = 0;       // m/s, of the particles against the exact parabola
  double shear = 0;     // Pa, mean over the wall of the middle part
  double gradient = 0;  // Pa/m, slope of the pressure along the middle part
};

/// The middle part of a channel or tube along axis x (2D) or z (3D); r is the distance from the axis.
class FullPoiseuille : public CaseRun {
 protected:
  Developed middle(int axis, double from, double to, double (*radius)(const std::array<double, 3>&)) const {
    const PointFile fluid = read_points(last_file(folder() / "results/fields", "fluid_"));
    const auto inside = [&](const std::array<double, 3>& x) { return x[axis] > from && x[axis] < to; };
    Developed d;
    double n = 0, uu = 0, ue = 0, error = 0, sx = 0, sp = 0, sxx = 0, sxp = 0;
    for (std::size_t i = 0; i < fluid.points.size(); ++i) {
      if (!inside(fluid.points[i])) continue;
      const double xi = 2.0 * radius(fluid.points[i]) / width, exact = 1.0 - xi * xi;
      const double u = fluid.fields.at("velocity")[i][axis], p = fluid.fields.at("pressure")[i][0];
      const double x = fluid.points[i][axis];
      ++n, uu += exact * exact, ue += u * exact, error += std::pow(u - u_max * exact, 2);
      sx += x, sp += p, sxx += x * x, sxp += x * p;
    }
    d.peak = ue / uu;
    d.rms = std::sqrt(error / n);
    d.gradient = -(n * sxp - sx * sp) / (n * sxx - sx * sx);
    const PointFile wall = read_points(last_file(folder() / "results/fields", "wall_"));
    double area = 0;
    for (std::size_t i = 0; i < wall.points.size(); ++i) {
      if (!inside(wall.points[i])) continue;
      const double a = wall.fields.at("area")[i][0];
      area += a, d.shear += a * wall.fields.at("wall_shear_stress")[i][axis];
    }
    d.shear /= area;
    return d;
  }

  Developed channel(int across) {
    run("poiseuille_2d", "--force --set 'vessel.spacing=" + std::to_string(1.0 / across) + " mm'");
    return middle(0, 1e-3, 3e-3, [](const std::array<double, 3>& x) { return std::abs(x[1] - 0.5e-3); });
  }
};

TEST_F(FullPoiseuille, Channel30Across) {
  const Developed d = channel(30);
  EXPECT_NEAR(d.peak, u_max, 0.005 * u_max);
  EXPECT_LT(d.rms, 0.01 * u_max);
  EXPECT_NEAR(d.shear, shear, 0.03 * shear);
  EXPECT_NEAR(d.gradient, 25.0, 0.05 * 25.0);  // 0.1 Pa over 4 mm
}

TEST_F(FullPoiseuille, ChannelConverges) {
  std::vector<double> error;
  for (const int across : {10, 20, 40}) {
    error.push_back(channel(across).rms / u_max);
    RecordProperty("rms_" + std::to_string(across), std::to_string(error.back()));
  }
  EXPECT_GE(std::log2(error[0] / error[2]) / 2, 1.5) << error[0] << " " << error[1] << " " << error[2];
}

TEST_F(FullPoiseuille, Tube30Across) {
  const auto tube = geometry("tube --radius '0.5 mm' --length '2 mm'");
  run("poiseuille_3d", "--surface '" + tube.string() + "'");
  const Developed d =
      middle(2, 0.5e-3, 1.5e-3, [](const std::array<double, 3>& x) { return std::hypot(x[0], x[1]); });
  EXPECT_NEAR(d.peak, u_max, 0.01 * u_max);
  EXPECT_NEAR(d.shear, shear, 0.03 * shear);
  EXPECT_NEAR(d.gradient, 50.0, 0.05 * 50.0);  // 0.1 Pa over 2 mm
}

}  // namespace
}  // namespace ostium::test
