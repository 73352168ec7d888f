// A patient's aorta: split, means and mass; the same waveforms wherever and however the surface lies.
#include "case_run.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::test {
namespace {

class FullAorta : public CaseRun {
 protected:
  void SetUp() override {
    const auto surface = data("aorta_vmr0024/aorta_vmr0024.stl");
    const auto inflow = data("aorta_vmr0024/0154_0001_inflow.txt");
    if (!surface || !inflow) GTEST_SKIP() << "needs the reference data (vessels/aorta_vmr0024)";
    surface_ = *surface, inflow_ = *inflow;
  }

  std::string options(const std::filesystem::path& surface) const {
    return "--surface '" + surface.string() + "' --set 'network.blocks.heart.flow.file=" + inflow_.string() +
           "' ";
  }

  /// The surface in metres, turned, ten metres away, its normals flipped.
  std::filesystem::path turned() const {
    auto surface = sph3d::read_lumen({.file = surface_, .length_unit = 1e-2}).surface;
    const Eigen::AngleAxisd turn(2.1, Vec3(-1, 0.4, 0.7).normalized());
    for (auto& x : surface.points) x = turn * x + Vec3(6.1, -6.3, 4.8);
    for (auto& f : surface.facets) std::swap(f[0], f[1]);
    const auto file = folder() / "turned.stl";
    write_stl(surface, file, 1.0);
    return file;
  }

  /// The aorta where it lies, with rows every 2 ms; run once for both tests.
  const std::map<std::string, PortSignals>& plain() {
    static const auto ports = [this] {
      run("aorta_vmr0024", rows + options(surface_));
      facts_ = summary();
      return this->ports();
    }();
    return ports;
  }

  /// Means over 10 ms, the distance of the rows of that case: what is faster is the noise of an arrangement of particles.
  static Signal slow(const Signal& signal) {
    constexpr std::size_t five = 5;
    Signal means;
    for (std::size_t n = 0; n + five <= signal.time.size(); n += five) {
      double t = 0, y = 0;
      for (std::size_t k = n; k < n + five; ++k) t += signal.time[k] / five, y += signal.value[k] / five;
      means.time.push_back(t), means.value.push_back(y);
    }
    return means;
  }

  /// rms of the difference over the swing of the second, in the second cycle: the start rings with the sound of the
  /// fluid at rest that is set in motion. (Both are compared at the same times: nothing is wrapped into a period.)
  static double difference(const Signal& a, const Signal& b) {
    const Signal first = slow(a.between(0.66, 1.32)), second = slow(b.between(0.66, 1.32));
    return rms_difference(first, second, 1e9) / (second.max() - second.min());
  }

  static constexpr const char* rows = "--set 'output.every=2 ms' ";
  static inline nlohmann::json facts_;
  std::filesystem::path surface_, inflow_;
};

TEST_F(FullAorta, SplitMeansAndMass) {
  const auto& all = plain();
  const std::map<std::string, double> expected{{"RSA", 11.0394e-6},
                                               {"RCCA", 10.6598e-6},
                                               {"LCCA", 10.6598e-6},
                                               {"LSA", 12.6350e-6},
                                               {"DAo", 77.6676e-6}};
  for (const auto& [name, flow] : expected) {
    const Signal &p = all.at(name).pressure, &volume = all.at(name).volume_out;
    EXPECT_NEAR((volume.at(1.32) - volume.at(0.66)) / 0.66, flow, 0.03 * flow) << name;
    const double first = p.between(0, 0.66).mean(), second = p.between(0.66, 1.32).mean();
    EXPECT_NEAR(first, second, 0.02 * second) << name;
  }
  EXPECT_EQ(facts_["escaped_particles"].get<int>(), 0);
  EXPECT_LE(facts_["mass_balance_relative_to_inflow"].get<double>(), 1e-10);
}

TEST_F(FullAorta, SameWaveformsInMetresTurnedTenMetresAwayAndInsideOut) {
  const auto& first = plain();
  run("aorta_vmr0024", rows + std::string("--force --set vessel.length_unit=m ") + options(turned()));
  const auto other = ports();
  ASSERT_EQ(other.size(), first.size());
  for (const auto& [name, port] : first) {
    const double pressure = difference(other.at(name).pressure, port.pressure),
                 flow = difference(other.at(name).flow_out, port.flow_out);
    RecordProperty(name + "_pressure", std::to_string(pressure));
    RecordProperty(name + "_flow", std::to_string(flow));
    EXPECT_LT(pressure, 0.01) << name << ", pressure";
    EXPECT_LT(flow, 0.01) << name << ", flow";
  }
}

}  // namespace
}  // namespace ostium::test
