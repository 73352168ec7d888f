#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

class Pages : public ProgramTest {};

TEST_F(Pages, Schema) {
  const auto schema = nlohmann::json::parse(ostium("schema").text);
  EXPECT_EQ(schema["required"], nlohmann::json({"network", "time"}));
  EXPECT_TRUE(schema["properties"]["vessel"]["properties"].contains("spacing"));
  const auto& types =
      schema["properties"]["network"]["properties"]["blocks"]["additionalProperties"]["oneOf"];
  EXPECT_TRUE(std::any_of(types.begin(), types.end(),
                          [](const auto& t) { return t["properties"]["type"]["const"] == "windkessel"; }));
}

TEST_F(Pages, Reference) {
  ASSERT_EQ(ostium("reference -o pages").code, 0);
  EXPECT_THAT(content("pages/case.md"),
              HasSubstr("| `spacing` | m | > 0 | required | particle spacing dp |"));
  EXPECT_THAT(content("pages/blocks.md"), HasSubstr("`windkessel`"));
  EXPECT_THAT(content("pages/blocks.md"), HasSubstr("| `Rp` | Pa.s/m3 | >= 0 | required |"));
  EXPECT_THAT(content("pages/waveform.md"), HasSubstr("| `interpolation` | linear, monotone_cubic |"));
}

TEST_F(Pages, VersionAndHelp) {
  EXPECT_THAT(ostium("--version").text, testing::MatchesRegex("ostium [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  const Outcome help = ostium("--help");
  EXPECT_EQ(help.code, 0);
  for (const char* command : {"run", "check", "schema", "reference"})
    EXPECT_THAT(help.text, HasSubstr(command));
}

}  // namespace
}  // namespace ostium::test
