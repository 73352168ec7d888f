#include "network/parameters.hpp"

#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using testing::HasSubstr;

const std::string rcr =
    "heart: {type: flow_source, to: A, flow: {fourier: {mean: 80, cos: [-60], sin: [10]}, unit: mL/s, "
    "period: 0.8 s}}\n"
    "bed: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.2e8 Pa.s/m3}\n";

TEST(Parameters, NamesAsInTheCaseFile) {
  std::vector<std::string> names;
  for (const auto& p : parameters(model(rcr))) names.push_back(p.name);
  EXPECT_EQ(names, (std::vector<std::string>{"heart.flow.factor", "heart.flow.shift",
                                             "heart.flow.fourier.mean", "heart.flow.fourier.cos.1",
                                             "heart.flow.fourier.sin.1", "bed.Rp", "bed.C", "bed.Rd"}));
  const Parameter Rd = parameter(model(rcr), "bed.Rd", "here");
  EXPECT_EQ(Rd.value, 1.2e8);
  EXPECT_EQ(Rd.unit, "Pa.s/m3");
}

TEST(Parameters, UnknownNames) {
  EXPECT_THAT(
      refusal([] { parameter(model(rcr), "bed.Rdd", "case.yaml:9:3"); }),
      HasSubstr(
          "case.yaml:9:3: there is no parameter \"bed.Rdd\"; a parameter is BLOCK.KEY with a key that the "
          "case gives or that has a default; did you mean \"bed.Rd\"?"));
  EXPECT_THAT(refusal([] { parameter(model(rcr), "bed.Pd", "x"); }),
              HasSubstr("there is no parameter \"bed.Pd\""));
}

/// A joined network with another value is the network joined with that value.
TEST(Parameters, SettingEqualsReadingAnew) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string yaml = rcr;
    return yaml.replace(yaml.find(from), from.size(), to);
  };
  const std::pair<std::string, std::string> changed[] = {{"Rd: 1.2e8", "Rd: 2.5e8"},
                                                         {"mean: 80", "mean: 70"}};
  const std::pair<std::string, double> set[] = {{"bed.Rd", 2.5e8}, {"heart.flow.fourier.mean", 70e-6}};
  for (int i = 0; i < 2; ++i) {
    Network anew(model(with(changed[i].first, changed[i].second))), reused(model(rcr));
    run_to(reused, 0.3);
    reused.set(parameter(model(rcr), set[i].first, ""), set[i].second);
    reused.restart();
    run_to(anew, 1.7), run_to(reused, 1.7);
    EXPECT_NEAR(series(reused, "p:A_Pa"), series(anew, "p:A_Pa"), 1e-9) << set[i].first;
  }
}

TEST(Parameters, ValuesReplaceEachOther) {
  Network n(model(rcr));
  const Parameter factor = parameter(model(rcr), "heart.flow.factor", ""),
                  Rd = parameter(model(rcr), "bed.Rd", "");
  const double before = (run_to(n, 0.5), series(n, "q:heart_m3_s"));
  n.set(factor, 3), n.set(Rd, 1e8), n.set(factor, 2), n.restart();
  run_to(n, 0.5);
  EXPECT_NEAR(series(n, "q:heart_m3_s"), 2 * before, 1e-18);
  EXPECT_EQ(parameter(n.model(), "bed.Rd", "").value, 1e8);
}

TEST(Parameters, BadValues) {
  Network n(model(
      "p: {type: pressure_source, to: A, pressure: 10 mmHg}\nv: {type: valve, from: A, ground: 0 mmHg, R: "
      "1e6 Pa.s/m3, L: 1e4 Pa.s2/m3, R_closed: 1e9 Pa.s/m3}\n"));
  const auto set = [&](const std::string& name, double value) {
    return refusal([&] { n.set(parameter(n.model(), name, ""), value); });
  };
  EXPECT_EQ(set("v.R", -1), "v.R is -1 Pa.s/m3, and must be >= 0 Pa.s/m3");
  EXPECT_THAT(set("v.R", NAN), HasSubstr("v.R is nan"));
  EXPECT_THAT(set("v.R", 2e9),
              HasSubstr("v.R = 2e+09 Pa.s/m3: \"R_closed\" is 1e+09 Pa.s/m3 and must be larger"));
  EXPECT_THAT(set("v.L", 0), HasSubstr("that value leaves an element of the block out, or adds one"));
  EXPECT_EQ(set("v.R", 2e6), "no error");  // what was refused left nothing behind
}

}  // namespace
}  // namespace ostium::network
