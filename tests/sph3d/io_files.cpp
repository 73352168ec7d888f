#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/geometry/polygon.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/io/fields.hpp"
#include "sph3d/io/preview.hpp"
#include "sph3d/io/pvd_series.hpp"

namespace ostium::sph3d {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / (std::string("ostium_io_") + test->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string text(const std::string& name) const {
    std::ifstream in(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  int count() const { return int(std::distance(fs::directory_iterator(folder), fs::directory_iterator())); }

  fs::path folder;
};

TEST_F(Files, ParticlesCarryTheirFields) {
  const std::vector<Vec3> x{{0, 0, 0}, {1, 2, 3}, {4, 5, 6}};
  const std::vector<double> p{1, 2, 3};
  write_particles_vtp<3>(folder / "f.vtp", x, std::vector{field("pressure", p), field<3>("velocity", x)});
  EXPECT_THAT(text("f.vtp"), AllOf(HasSubstr("NumberOfPoints=\"3\""), HasSubstr("Name=\"pressure\""),
                                   HasSubstr("NumberOfComponents=\"3\""), HasSubstr("Float32"),
                                   HasSubstr("vtkLZ4DataCompressor"), HasSubstr("appended")));
  EXPECT_EQ(count(), 1) << "nothing unfinished stays behind";
}

TEST_F(Files, PlaneParticlesBecomeSpatial) {
  const std::vector<Vec2> x{{0, 0}, {1, 2}};
  const auto velocity = field<2>("velocity", x);
  EXPECT_EQ(velocity.components, 2);
  write_particles_vtp<2>(folder / "f.vtp", x, std::vector{velocity});
  EXPECT_THAT(text("f.vtp"), HasSubstr("Name=\"velocity\" NumberOfComponents=\"3\""));
}

TEST_F(Files, NoParticlesIsAFileToo) {
  write_particles_vtp<3>(folder / "f.vtp", {}, {});
  EXPECT_THAT(text("f.vtp"), HasSubstr("NumberOfPoints=\"0\""));
}

TEST_F(Files, SurfaceReadsBack) {
  const auto lumen = shapes::tube_lumen(0.01, 0.1);
  std::vector<double> height;
  for (const auto& x : lumen.surface.points) height.push_back(x.z());
  write_surface_vtp<3>(folder / "s.vtp", lumen.surface, std::vector{field("height", height)});
  const auto back = read_lumen({.file = folder / "s.vtp"});
  EXPECT_NEAR(back.volume, lumen.volume, 1e-6 * lumen.volume);
  EXPECT_EQ(back.openings.size(), 2u);
  EXPECT_THAT(text("s.vtp"), AllOf(HasSubstr("Name=\"height\""), HasSubstr("Name=\"opening\"")));
}

TEST_F(Files, UnwritableIsSaid) {
  try {
    write_particles_vtp<3>(folder / "no" / "f.vtp", {}, {});
    FAIL();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("f.vtp: cannot be written"), HasSubstr("is the folder there")));
  }
}

TEST_F(Files, SeriesIsCompleteAfterEachStepAndGoesOn) {
  PvdSeries series(folder / "fluid.pvd");
  for (int k = 0; k < 3; ++k) {
    series.add(0.01 * k, folder / "fields" / fmt::format("fluid_{}.vtp", k));
    EXPECT_THAT(text("fluid.pvd"),
                AllOf(HasSubstr(fmt::format("fields/fluid_{}.vtp", k)), HasSubstr("</VTKFile>")));
  }
  PvdSeries again(folder / "fluid.pvd");
  again.resume(0.01);
  EXPECT_EQ(again.size(), 2u);
  again.add(0.015, folder / "fields" / "later.vtp");
  EXPECT_THAT(text("fluid.pvd"), AllOf(HasSubstr("timestep=\"0.01\" file=\"fields/fluid_1.vtp\""),
                                       HasSubstr("later.vtp"), Not(HasSubstr("fluid_2.vtp"))));
  EXPECT_EQ(count(), 1);
}

/// Width and height stand at fixed places of a PNG file.
std::pair<int, int> png_size(const std::string& bytes) {
  const auto number = [&](int at) {
    int n = 0;
    for (int k = 0; k < 4; ++k) n = 256 * n + static_cast<unsigned char>(bytes.at(at + k));
    return n;
  };
  return {number(16), number(20)};
}

TEST_F(Files, PreviewOfBothDimensions) {
  preview(shapes::tube_lumen(0.01, 0.1),
          {.title = "tube", .notes = {"a network"}, .width = 800, .height = 500}, folder / "3.png");
  EXPECT_EQ(png_size(text("3.png")), std::pair(800, 500));
  EXPECT_GT(text("3.png").size(), 8000u) << "an empty picture is smaller";
  const std::vector<Vec2> corners{{0, 0}, {0, 0.01}, {0.05, 0.01}, {0.05, 0}};
  const std::vector<OutlineOpening> ends{{.name = "in", .edge = 0}, {.name = "out", .edge = 2}};
  preview(polygon_lumen(corners, ends), {}, folder / "2.png");
  EXPECT_EQ(png_size(text("2.png")), std::pair(1600, 1000));
}

TEST_F(Files, PreviewWithoutAnyDisplay) {
  const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
  const char* display = std::getenv("DISPLAY");
  const std::string before = display ? display : "";
  setenv("PATH", folder.c_str(), 1), unsetenv("DISPLAY");
  std::string said;
  try {
    preview(shapes::tube_lumen(0.01, 0.1), {}, folder / "p.png");
  } catch (const UserError& error) {
    said = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  if (display) setenv("DISPLAY", before.c_str(), 1);
  EXPECT_THAT(said, AllOf(HasSubstr("no display"), HasSubstr("apt install xvfb")));
  EXPECT_EQ(count(), 0);
}

}  // namespace
}  // namespace ostium::sph3d
