#include "core/did_you_mean.hpp"

#include <gtest/gtest.h>

namespace ostium {
namespace {

TEST(DidYouMean, EditDistance) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("form", "from"), 1);  // one swap
  EXPECT_EQ(edit_distance("same", "same"), 0);
}

TEST(DidYouMean, NearestIgnoresCaseAndFarNames) {
  EXPECT_EQ(nearest_name("viscosty", {"density", "viscosity"}), "viscosity");
  EXPECT_EQ(nearest_name("RP", {"Rp", "C", "Rd"}), "Rp");
  EXPECT_EQ(nearest_name("xylophone", {"density", "viscosity"}), std::nullopt);
  EXPECT_EQ(nearest_name("Cc", {"Rp", "C", "Rd"}), "C");
  EXPECT_EQ(nearest_name("a", {"b", "c"}), std::nullopt);
  EXPECT_EQ(nearest_name("anything", {}), std::nullopt);
}

TEST(DidYouMean, Sentence) {
  EXPECT_EQ(did_you_mean("Dao", {"AAo", "DAo"}), "; did you mean \"DAo\"? Allowed: AAo, DAo");
  EXPECT_EQ(did_you_mean("zzzz", {"AAo", "DAo"}), "; Allowed: AAo, DAo");
  EXPECT_EQ(did_you_mean("zzzz", {}), "");
}

}  // namespace
}  // namespace ostium
