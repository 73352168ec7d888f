#include "core/units.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <thread>

#include "errors.hpp"

namespace ostium {
namespace {

using test::error_of;
using testing::HasSubstr;

TEST(Units, ClinicalUnitsConvertToSi) {
  EXPECT_NEAR(quantity("80 mmHg", "Pa"), 80 * 133.322387415, 1e-6);
  EXPECT_DOUBLE_EQ(quantity("5 L/min", "m3/s"), 5e-3 / 60);
  EXPECT_DOUBLE_EQ(quantity("1 mL/s", "m3/s"), 1e-6);
  EXPECT_DOUBLE_EQ(quantity("4 mPa.s", "Pa.s"), 4e-3);
  EXPECT_DOUBLE_EQ(quantity("4 cP", "Pa.s"), 4e-3);
  EXPECT_DOUBLE_EQ(quantity("0.04 P", "Pa.s"), 4e-3);
  EXPECT_DOUBLE_EQ(quantity("1 dyn", "N"), 1e-5);
  EXPECT_DOUBLE_EQ(quantity("1000 dyn.s/cm5", "Pa.s/m3"), 1e8);
  EXPECT_DOUBLE_EQ(quantity("1e-5 cm5/dyn", "m3/Pa"), 1e-10);
  EXPECT_DOUBLE_EQ(quantity("72 beats/min", "1/s"), 1.2);
  EXPECT_DOUBLE_EQ(quantity("72 bpm", "1/s"), 1.2);
  EXPECT_DOUBLE_EQ(quantity("1.06 g/cm3", "kg/m3"), 1060);
  EXPECT_DOUBLE_EQ(quantity("600 um", "m"), 6e-4);
  EXPECT_DOUBLE_EQ(quantity("180 deg", "rad"), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(quantity("45 %", "1"), 0.45);
}

TEST(Units, SpellingsOfNumbers) {
  EXPECT_DOUBLE_EQ(quantity("+5 m", "m"), 5);
  EXPECT_DOUBLE_EQ(quantity("  -5e-3m ", "m"), -5e-3);
  EXPECT_DOUBLE_EQ(quantity("7.13e7 Pa s m-3", "Pa.s/m3"), 7.13e7);
  EXPECT_DOUBLE_EQ(quantity("7.13e7 Pa*s/m^3", "Pa.s/m3"), 7.13e7);
}

TEST(Units, SameUnitKeepsEveryBit) {
  for (double x : {0.1, 1.0 / 3, 9.8e6, 6.02e-9, std::numeric_limits<double>::max()})
    EXPECT_EQ(quantity(shortest(x) + " Pa.s/m3", "Pa.s/m3"), x);
}

TEST(Units, BareNumberAsksForTheUnit) {
  EXPECT_EQ(
      error_of([] { quantity("9.8e6", "Pa.s/m3"); }),
      "expected a value with a unit of dimension Pa.s/m3, found the bare number 9.8e6; write for example "
      "\"9.8e6 Pa.s/m3\"");
}

TEST(Units, WrongDimensionNamesUnitsThatFit) {
  const auto text = error_of([] { quantity("80 mmHg", "m3/s"); });
  EXPECT_THAT(text,
              HasSubstr("the unit \"mmHg\" has the wrong dimension; expected a unit that converts to m3/s"));
  EXPECT_THAT(text, HasSubstr("mL/s, L/min"));
}

TEST(Units, ReciprocalIsAnotherDimension) {
  EXPECT_THAT(error_of([] { quantity("5 Hz", "s"); }), HasSubstr("wrong dimension"));
  EXPECT_THAT(error_of([] { quantity("5 m3/s/Pa", "Pa.s/m3"); }), HasSubstr("wrong dimension"));
}

TEST(Units, MisspeltUnit) {
  EXPECT_EQ(error_of([] { quantity("80 mmGh", "Pa"); }), "unknown unit \"mmGh\"; did you mean \"mmHg\"?");
  EXPECT_NEAR(quantity("1 mmhg", "Pa"), 133.322387415, 1e-6);  // names are read in any letter case
  EXPECT_EQ(error_of([] { quantity("80 florps", "Pa"); }), "unknown unit \"florps\"");
}

TEST(Units, NotANumber) {
  EXPECT_EQ(error_of([] { quantity("fast", "m/s"); }), "\"fast\" does not begin with a number");
  EXPECT_EQ(error_of([] { quantity("", "m/s"); }), "\"\" does not begin with a number");
  EXPECT_EQ(error_of([] { quantity("9,81 m", "m"); }),
            "\"9,81 m\" is no number; write a decimal point, not a comma");
  EXPECT_EQ(error_of([] { quantity("1.2.3 m", "m"); }), "\"1.2.3 m\" is no number with a unit");
  EXPECT_EQ(error_of([] { quantity("nan m", "m"); }), "\"nan m\" is not a finite number");
  EXPECT_EQ(error_of([] { quantity("-inf m", "m"); }), "\"-inf m\" is not a finite number");
  EXPECT_EQ(error_of([] { quantity("1e999 m", "m"); }), "\"1e999 m\" is too large or too small for a number");
  EXPECT_EQ(error_of([] { parse_number("5 m"); }), "\"5 m\" is not a plain number");
}

TEST(Units, StrangeUnitsNeverCrash) {
  for (const char* unit : {"((", "m^^2", "m3/", "/s", "@", "s since 2000-01-01", "lg(re 1 mW)", "\x01",
                           "m m m m", "1e400 m", "m^999999", "\xff\xfe", "5 m", "K @ 273.15"})
    EXPECT_NE(error_of([&] { quantity(std::string("1 ") + unit, "Pa.s/m3"); }), "no error") << unit;
}

TEST(Units, ManyThreads) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4);
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&sums, k] {
      for (int i = 0; i < 500; ++i)
        sums[k] += quantity(fmt::format("1 cm{}", 1 + i % 5), fmt::format("m{}", 1 + i % 5));
    });
  for (auto& t : threads) t.join();
  EXPECT_NEAR(sums[0], 100 * (1e-2 + 1e-4 + 1e-6 + 1e-8 + 1e-10), 1e-12);
  for (double s : sums) EXPECT_EQ(s, sums[0]);
}

}  // namespace
}  // namespace ostium
