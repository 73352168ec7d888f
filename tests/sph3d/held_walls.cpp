// Walls that could move, held: the flow is that of the rigid wall.
#include <gtest/gtest.h>

#include "plane_poiseuille.hpp"
#include "sph3d/solid/solid_wall.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

const Material soft = SaintVenantKirchhoff({.E = 1e3, .nu = 0.3});  // nothing moves: long steps

std::unique_ptr<DeformableWall<2>> held_shell(double length, double width, double dp, double reach) {
  ShellCloud<2> cloud;
  std::vector<Vec2> contact;
  for (const double side : {-1.0, 1.0})
    for (double x = 0.5 * dp; x < length; x += dp) {
      contact.emplace_back(x, 0.5 * (1 + side) * width);
      cloud.position.push_back(contact.back() + 0.5 * dp * Vec2(0, side));
      cloud.normal.push_back(Vec2(0, side));
      cloud.area.push_back(dp);
      cloud.thickness.push_back(dp);
      cloud.support.push_back(Support::clamped);
      cloud.axis.push_back(Vec2(1, 0));
    }
  const ShellOptions options{.spacing = dp, .density = 1000, .material = soft};
  return std::make_unique<DeformableWall<2>>(ShellModel<2>(cloud, options), contact, reach,
                                             SurroundingsOfWall{});
}

std::unique_ptr<DeformableWall<2>> held_solid(double length, double width, double dp, double reach) {
  auto wall = solid_of(channel(length, width), {.spacing = dp, .fluid_spacing = dp, .thickness = 4 * dp});
  wall.solid.held.assign(wall.solid.held.size(), hold_all);
  const SolidOptions tissue{.material = soft, .density = 1000, .spacing = dp, .damping = 1.0};
  return std::make_unique<DeformableWall<2>>(SolidBody<2>(wall, tissue), reach, SurroundingsOfWall{});
}

void expect_exact(const char* name, const MakeChannelWall& wall) {
  const auto at30 = plane_poiseuille(30, 3.0, wall);
  printf("%s: peak %+.3f %%, profile rms %.3f %%, shear stress %.4f\n", name, 100 * at30.peak_error,
         100 * at30.profile_error, at30.shear_stress);
  EXPECT_LT(std::abs(at30.peak_error), 0.005);
  EXPECT_LT(at30.profile_error, 0.005);
  EXPECT_NEAR(at30.shear_stress, 1.0, 0.01);
}

TEST(FullFlow, PlanePoiseuilleInAHeldShell) { expect_exact("shell", held_shell); }
TEST(FullFlow, PlanePoiseuilleInAHeldSolid) { expect_exact("solid", held_solid); }

}  // namespace
}  // namespace ostium::sph3d
