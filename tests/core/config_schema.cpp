#include "core/config/schema.hpp"

#include <gmock/gmock.h>

#include "config_struct.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

TEST(ConfigSchema, FollowsTheDeclaration) {
  const auto schema = config::schema<Study>();
  EXPECT_EQ(schema["type"], "object");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_FALSE(schema.contains("required"));
  const auto& p = schema["properties"];
  EXPECT_EQ(p["scheme"]["enum"], nlohmann::json({"linearised", "held"}));
  EXPECT_EQ(p["porosity"]["anyOf"][0]["exclusiveMaximum"], 1.0);
  EXPECT_EQ(p["cycles"]["minimum"], 1.0);
  EXPECT_EQ(p["blocks"]["additionalProperties"]["required"], nlohmann::json({"Rp", "C"}));
  EXPECT_EQ(p["blocks"]["additionalProperties"]["properties"]["Rp"]["description"],
            "proximal resistance [Pa.s/m3]; > 0 Pa.s/m3");
  EXPECT_EQ(p["output"]["properties"]["every"]["default"], "0.01 s");
}

TEST(ConfigSchema, ReferencePage) {
  const std::string page = config::reference<Study>("Study");
  EXPECT_THAT(page, HasSubstr("## Study\n\n| key | unit or kind | range | default | meaning |"));
  EXPECT_THAT(page, HasSubstr("| `cycles` | integer | >= 1 and <= 100 | `2` | number of cycles |"));
  EXPECT_THAT(page, HasSubstr("### `blocks.NAME`"));
  EXPECT_THAT(page, HasSubstr("| `Rp` | Pa.s/m3 | > 0 | required | proximal resistance |"));
  EXPECT_THAT(page, HasSubstr("| `every` | s | > 0 | `0.01 s` | interval of the series |"));
}

}  // namespace
}  // namespace ostium::test
