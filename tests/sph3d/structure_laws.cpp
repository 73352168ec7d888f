// Laws of walls: energy and stress belong together, exact solutions, plane stress, lanes, refusals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <experimental/simd>
#include <random>

#include "core/error.hpp"
#include "sph3d/structure/material.hpp"

namespace ostium::sph3d {
namespace {

using testing::HasSubstr;
using Strain = Sym3<double>;

const Moduli soft = elastic(1e5, 0.45), stiff_volume = elastic_from_mu_K(1e5, 1e10);
const Fibres<double> crossed = fibres_at_angle(Vec3::UnitX(), Vec3::UnitZ(), 0.7);

const std::vector<Material> laws = {SaintVenantKirchhoff(soft), NeoHookean(soft),
                                    holzapfel(soft, {.k1 = 4e4, .k2 = 3.0, .kappa = 0.1}),
                                    holzapfel(soft, {.k1 = 4e4, .k2 = 3.0})};

double& component(Strain& E, int k) {
  double* all[] = {&E.xx, &E.yy, &E.zz, &E.xy, &E.yz, &E.zx};
  return *all[k];
}

Strain random_strain(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> any(-size, size);
  Strain E;
  for (int k = 0; k < 6; ++k) component(E, k) = any(random);
  return E;
}

Eigen::Matrix3d matrix(const Strain& E) {
  Eigen::Matrix3d m;
  m << E.xx, E.xy, E.zx, E.xy, E.yy, E.yz, E.zx, E.yz, E.zz;
  return m;
}

Strain tensor(const Eigen::Matrix3d& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}; }

TEST(StructureLaws, StressIsTheDerivativeOfTheEnergy) {
  std::mt19937 random(1);
  for (const auto& material : laws)
    std::visit(
        [&](const auto& law) {
          for (int trial = 0; trial < 20; ++trial) {
            const Strain E = random_strain(random, 0.15);
            Strain S = law.stress(E, crossed);
            for (int k = 0; k < 6; ++k) {
              Strain up = E, down = E;
              component(up, k) += 1e-5, component(down, k) -= 1e-5;
              const double slope = (law.energy(up, crossed) - law.energy(down, crossed)) / 2e-5;
              EXPECT_NEAR(slope, (k < 3 ? 1.0 : 2.0) * component(S, k), 1e-2) << law.name;  // of 1e4 Pa
            }
          }
        },
        material);
}

TEST(StructureLaws, SlopeAcrossTheThicknessIsADerivative) {
  std::mt19937 random(2);
  for (const auto& material : laws)
    std::visit(
        [&](const auto& law) {
          const Strain E = random_strain(random, 0.15);
          Strain up = E, down = E;
          up.zz += 1e-6, down.zz -= 1e-6;
          const auto s = law.thickness_stress(E, crossed);
          const double slope =
              (law.thickness_stress(up, crossed).value - law.thickness_stress(down, crossed).value) / 2e-6;
          EXPECT_NEAR(s.slope, slope, 1e-6 * slope) << law.name;
        },
        material);
}

TEST(StructureLaws, SmallStrainIsHookes) {
  std::mt19937 random(3);
  const Strain E = random_strain(random, 1e-7);
  const Strain hooke = SaintVenantKirchhoff(soft).stress(E);
  for (int k = 0; k < 6; ++k) {
    Strain S = NeoHookean(soft).stress(E), H = hooke;
    EXPECT_NEAR(component(S, k), component(H, k), 1e-5 * 0.02);
  }
  for (const auto& material : laws) {
    EXPECT_NEAR(moduli(material).E, soft.E, 1e-9 * soft.E);
    EXPECT_NEAR(moduli(material).nu, soft.nu, 1e-12);
  }
}

TEST(StructureLaws, TurnedStrainGivesTurnedStress) {
  std::mt19937 random(4);
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(0.8, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
  Fibres<double> turned = crossed;
  Eigen::Map<Vec3>(turned.first) = Q * Eigen::Map<const Vec3>(crossed.first);
  Eigen::Map<Vec3>(turned.second) = Q * Eigen::Map<const Vec3>(crossed.second);
  for (const auto& material : laws)
    std::visit(
        [&](const auto& law) {
          const Strain E = random_strain(random, 0.15);
          const Eigen::Matrix3d expected = Q * matrix(law.stress(E, crossed)) * Q.transpose();
          const Eigen::Matrix3d found = matrix(law.stress(tensor(Q * matrix(E) * Q.transpose()), turned));
          EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm()) << law.name;
        },
        material);
}

double green(double stretch) { return 0.5 * (stretch * stretch - 1.0); }

TEST(StructureLaws, SaintVenantKirchhoffPulledOneWay) {
  const SaintVenantKirchhoff law(soft);
  const double E = green(1.3);
  const Strain S = law.stress(Strain{.xx = E, .yy = -soft.nu * E, .zz = -soft.nu * E});
  EXPECT_NEAR(S.xx, soft.E * E, 1e-9 * soft.E);
  EXPECT_NEAR(S.yy, 0.0, 1e-9 * soft.E);
  const Strain sheet = plane_stress(law, Strain{.xx = E}).stress;
  EXPECT_NEAR(sheet.xx, soft.plate() * E, 1e-9 * soft.E);
}

TEST(StructureLaws, IncompressibleRubberPulledOneWayAndTwo) {
  const NeoHookean law(stiff_volume);
  const double mu = 1e5;
  for (const double l : {0.7, 1.0, 1.2, 1.6}) {
    const auto one = plane_stress(law, Strain{.xx = green(l), .yy = green(1.0 / std::sqrt(l))});
    EXPECT_NEAR(one.stress.xx * l * l, mu * (l * l - 1.0 / l), 1e-4 * mu);
    EXPECT_NEAR(one.stress.yy, 0.0, 1e-4 * mu);
    const auto two = plane_stress(law, Strain{.xx = green(l), .yy = green(l)});
    EXPECT_NEAR(two.stress.xx * l * l, mu * (l * l - std::pow(l, -4)), 4e-4 * mu);  // pressure / K: 4e-5
    EXPECT_NEAR(two.thickness_stretch(), 1.0 / (l * l), 1e-4);
  }
}

TEST(StructureLaws, CompressibleRubberPulledTwoWays) {
  // S_zz = 0 for stretches (l, l, t) reads mu J^(-2/3) (t^2 - l^2) 2/3 + K/2 (J^2 - 1) = 0 with J = l^2 t: by bisection.
  const NeoHookean law(soft);
  const double l = 1.4;
  double low = 0.2, high = 1.0;
  const auto excess = [&](double t) {
    const double J = l * l * t;
    return soft.mu() * std::pow(J, -2.0 / 3.0) * (t * t - l * l) * 2.0 / 3.0 + 0.5 * soft.K() * (J * J - 1.0);
  };
  for (int k = 0; k < 60; ++k) (excess(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
  const auto sheet = plane_stress(law, Strain{.xx = green(l), .yy = green(l)});
  EXPECT_NEAR(sheet.thickness_stretch(), low, 1e-9);
  // With S_zz = 0 the Cauchy stress is the difference of the deviators, mu J^(-5/3) (l^2 - t^2).
  const double J = l * l * low, cauchy = soft.mu() * std::pow(J, -5.0 / 3.0) * (l * l - low * low);
  EXPECT_NEAR(sheet.stress.xx * l * l / J, cauchy, 1e-8 * cauchy);
}

TEST(StructureLaws, FibresStretchedTwoWaysAndSlackInCompression) {
  const auto law = holzapfel(stiff_volume, {.k1 = 5e4, .k2 = 2.0});
  const auto diagonal = fibres_at_angle(Vec3::UnitX(), Vec3::UnitZ(), pi / 4);
  const double l = 1.2, e = l * l - 1.0;
  const auto sheet = plane_stress(law, Strain{.xx = green(l), .yy = green(l)}, diagonal);
  const double exact = 1e5 * (1.0 - std::pow(l, -6)) + 2.0 * 5e4 * e * std::exp(2.0 * e * e);
  EXPECT_NEAR(sheet.stress.xx, exact, 1e-4 * exact);
  const Strain shorter{.xx = green(0.9), .yy = green(0.9)};
  EXPECT_EQ(law.stress(shorter, diagonal).xx, law.rubber.stress(shorter).xx);
}

TEST(StructureLaws, DispersedInAllDirectionsIsIsotropic) {
  const auto law = holzapfel(soft, {.k1 = 5e4, .k2 = 2.0, .kappa = 1.0 / 3.0});
  const Strain E{.xx = 0.2, .yy = 0.1, .zz = -0.1, .xy = 0.05};
  EXPECT_NEAR(law.stress(E, crossed).xx, law.stress(E, Fibres<double>{}).xx, 1e-9 * soft.E);
}

TEST(StructureLaws, NothingPressesOnASheet) {
  std::mt19937 random(5);
  for (auto m : {elastic(1e5, 0.0), elastic(1e5, 0.3), soft, elastic(1e5, 0.495)})
    for (const Material material : {Material(SaintVenantKirchhoff(m)), Material(NeoHookean(m)),
                                    Material(holzapfel(m, {.k1 = 1e5, .k2 = 4.0, .kappa = 0.2}))})
      std::visit(
          [&](const auto& law) {
            // Fibres in rubber that shrinks freely would press it to nothing: they are meant for volumes that stay.
            if (law.has_fibres && m.nu < 0.45) return;
            for (const double lx : {0.7, 1.0, 1.3, 1.6})
              for (const double ly : {0.7, 1.0, 1.3, 1.6}) {
                Strain E = random_strain(random, 0.05);
                E.xx = green(lx), E.yy = green(ly);
                const auto sheet = plane_stress(law, E, crossed);
                const double left = std::abs(law.stress(sheet.strain, crossed).zz) / m.mu();
                EXPECT_LT(left, 1e-8) << law.name << ", nu " << m.nu << ", stretches " << lx << ", " << ly;
              }
          },
          material);
}

TEST(StructureLaws, LanesAndNumbersAgree) {
  using Lanes = std::experimental::native_simd<double>;
  std::mt19937 random(6);
  for (const auto& material : laws)
    std::visit(
        [&](const auto& law) {
          std::vector<Strain> E(Lanes::size());
          for (auto& e : E) e = random_strain(random, 0.1);
          const auto lanes = [&](double Strain::*c) { return Lanes([&](auto k) { return E[k].*c; }); };
          Fibres<Lanes> fibres;
          for (int d = 0; d < 3; ++d)
            fibres.first[d] = crossed.first[d], fibres.second[d] = crossed.second[d];
          const Sym3<Lanes> strain{lanes(&Strain::xx), lanes(&Strain::yy), lanes(&Strain::zz),
                                   lanes(&Strain::xy), lanes(&Strain::yz), lanes(&Strain::zx)};
          const auto sheet = plane_stress(law, strain, fibres);
          const auto psi = law.energy(strain, fibres);
          for (std::size_t k = 0; k < E.size(); ++k) {
            const auto one = plane_stress(law, E[k], crossed);
            EXPECT_NEAR(sheet.stress.xy[k], one.stress.xy, 1e-9 * soft.E) << law.name;
            EXPECT_NEAR(sheet.strain.zz[k], one.strain.zz, 1e-12) << law.name;
            EXPECT_NEAR(psi[k], law.energy(E[k], crossed), 1e-9 * soft.E) << law.name;
          }
        },
        material);
}

TEST(StructureLaws, FunctionsOfLanes) {
  for (double x = 0.1; x <= 10.0; x *= 1.01)
    EXPECT_NEAR(inverse_cube_root(x) * std::cbrt(x), 1.0, 1e-14) << x;
  for (double x = 0.0; x <= 50.0; x += 0.37) EXPECT_NEAR(exponential(x) * std::exp(-x), 1.0, 2e-12) << x;
}

TEST(StructureLaws, WaveSpeeds) {
  const Moduli m = elastic(1e6, 0.3);
  EXPECT_NEAR(wave_speed(m.plate(), 1000.0), std::sqrt(1e6 / 0.91 / 1000.0), 1e-9);
  EXPECT_NEAR(m.p_wave(), m.lambda() + 2.0 * m.mu(), 1e-6);
  // The tangent of a fibre that is stretched, by differences along it, is below the bound.
  const auto law = holzapfel(soft, {.k1 = 5e4, .k2 = 2.0});
  const Fibres<double> along;
  const double up = law.stress(Strain{.xx = green(1.2) + 1e-6}, along).xx,
               down = law.stress(Strain{.xx = green(1.2) - 1e-6}, along).xx;
  const double fibre = (up - down) / 2e-6 * 1.2 * 1.2;
  EXPECT_GT(law.plate_modulus(1.2), 0.9 * fibre);
  EXPECT_LT(law.plate_modulus(1.2), 1.5 * fibre);
}

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const UserError& e) {
    return e.what();
  }
  return "nothing was refused";
}

TEST(StructureLaws, RefuseWhatNoWallIsMadeOf) {
  EXPECT_EQ(refusal([] { elastic(-2e5, 0.3, "vessel.wall"); }),
            "The Young's modulus of vessel.wall must be positive; found -200000 Pa.");
  EXPECT_THAT(refusal([] { elastic(1e5, 0.5); }), HasSubstr("must be below 0.5; found 0.5."));
  EXPECT_THAT(refusal([] { elastic(1e5, 0.5); }), HasSubstr("Use 0.49"));
  EXPECT_EQ(refusal([] { elastic(1e5, -1.0); }),
            "Poisson's ratio of the wall must lie between -1 and 0.5; found -1.");
  EXPECT_THAT(refusal([] { elastic(1e5, NAN); }), HasSubstr("must lie between -1 and 0.5; found nan"));
  EXPECT_THAT(refusal([] { elastic_from_mu_K(1e5, 0.0); }),
              HasSubstr("bulk modulus of the wall must be positive"));
  EXPECT_THAT(refusal([] { holzapfel(soft, {.k1 = 0.0, .k2 = 1.0}); }),
              HasSubstr("fibre stiffness k1 of the wall must be positive; found 0 Pa"));
  EXPECT_THAT(refusal([] { holzapfel(soft, {.k1 = 1e4, .k2 = -1.0}); }),
              HasSubstr("stiffening k2 of the fibres"));
  EXPECT_THAT(refusal([] { holzapfel(soft, {.k1 = 1e4, .k2 = 1.0, .kappa = 0.4}); }),
              HasSubstr("between 0 (all in one direction) and 1/3 (in all directions alike); found 0.4"));
}

}  // namespace
}  // namespace ostium::sph3d
