// SPDX-License-Identifier: Apache-2.0
// Without these a crash would end a stress run, a broken technique would pass it, and a refusal could be mute.

#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class Stress : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  /// A copy of `hard` whose visibility is `expression`, which may use `visibility` and the parameter `bias_texels`.
  void write_technique(const std::string& expression) const {
    const std::filesystem::path home = source_dir() / "realtime" / "techniques";
    std::filesystem::copy(home / "hard", folder() / "tried");
    write("tried/hard.frag",
          "#include \"pixel.glsl\"\n#include \"shadow_map.glsl\"\nvoid main() {\n  Receiver receiver;\n"
          "  float visibility = 1.0;\n"
          "  if (fetch_receiver(receiver)) visibility = hard_visibility(shadow_map, view_light, receiver);\n"
          "  out_visibility = " +
              expression + ";\n}\n");
  }
  void write_suite(const std::string& axes) const {
    write("suite.toml",
          "schema = 1\nwidth_px = 48\nheight_px = 36\nsamples_per_pixel = 64\ntechniques = [\"./tried\"]\n" +
              axes);
  }
  Json stressed(int exit_code, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"stress", "suite.toml", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = umbrameter(arguments, {.timeout_s = 300});
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return Json::parse(result.out, nullptr, false);
  }
};

Json range(const Json& results, const std::string& axis, const std::string& row) {
  for (const Json& one : results["ranges"]) {
    if (one["axis"] == axis && one["row"] == row) return one;
  }
  return {};
}

constexpr const char* kBiasAxis = "[[axis]]\nparameter = \"bias_texels\"\nvalues = [0.1, 1, 2, 3, 10]\n";

TEST_F(Stress, TheSmallSuiteKeepsTheRules) {
  const std::filesystem::path suite = source_dir() / "suites" / "stress-small.toml";
  const ProcessResult result =
      umbrameter({"stress", suite.string(), "--json", "--out", "o"}, {.timeout_s = 600});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Json results = Json::parse(result.out);
  EXPECT_EQ(results["violations"].size(), 0u) << results["violations"].dump();
  size_t refusals = 0, exact_points = 0;
  for (const Json& cell : results["cells"]) {
    const bool is_refused = cell["outcome"] == "refused" || cell["outcome"] == "rightly_refused";
    refusals += is_refused ? 1 : 0;
    if (is_refused) {
      EXPECT_GT(cell["how"].get<std::string>().size(), 20u) << cell.dump();
    }
    exact_points += cell["exact_points"].get<size_t>();
  }
  EXPECT_GT(refusals, 10u);
  EXPECT_GT(exact_points, 1000u);  // the truth was held against the oracle
  for (const char* axis : {"world_offset", "scene_scale", "rect_size", "rect_height", "sphere_height"}) {
    const Json truth = range(results, axis, "truth");
    EXPECT_TRUE(truth["break_before"].is_null() && truth["break_after"].is_null()) << truth.dump();
  }
  for (const char* name : {"stress.json", "report.html", "stress.md"})
    EXPECT_TRUE(std::filesystem::exists(folder() / "o" / name)) << name;
}

TEST_F(Stress, ABreakIsFoundAtItsValueAndNamed) {
  write_technique(
      "bias_texels > 2.5 ? 1.0 - visibility : visibility");  // from 3 on light and dark change places
  write_suite(kBiasAxis);
  const Json found = range(stressed(0), "bias_texels", "hard");
  EXPECT_EQ(found["last"], "2") << found.dump();
  EXPECT_EQ(found["break_after"]["value"], "3");
  EXPECT_EQ(found["break_after"]["outcome"], "worse");
  EXPECT_EQ(found["break_after"]["how"], "extra_shadow") << found.dump();
}

TEST_F(Stress, ATechniqueWithNaNBreaksTheRules) {
  write_technique("bias_texels > 5.0 ? intBitsToFloat(0x7fc00000) : visibility");
  write_suite(kBiasAxis);
  const Json results = stressed(1);
  const Json found = range(results, "bias_texels", "hard");
  EXPECT_EQ(found["last"], "3");
  EXPECT_EQ(found["break_after"]["outcome"], "bad_value");
  EXPECT_THAT(results["violations"].at(0).get<std::string>(), HasSubstr("visibility nan at pixel"));
}

TEST_F(Stress, AHangIsAnOutcomeAndTheRestGoesOn) {
  // Far too much for any device, and nothing that a compiler may leave out; llvmpipe ends loops after 65535 rounds.
  std::string round = "out_visibility = fract(sin(out_visibility + float(i)) * 1.7); ";
  for (int doubling = 0; doubling < 9; ++doubling) round += round;
  write_technique(
      "visibility;\n  if (bias_texels > 2.5 && bias_texels < 5.0)\n    for (int i = 0; i < 1 << 30; ++i) { " +
      round + "}\n  out_visibility = out_visibility");
  write_suite(kBiasAxis);
  const Json results = stressed(1, {"--timeout", "10"});
  const Json found = range(results, "bias_texels", "hard");
  EXPECT_EQ(found["break_after"]["value"], "3") << found.dump();
  EXPECT_EQ(found["break_after"]["outcome"], "hang");
  EXPECT_EQ(results["cells"].size(), 10u);  // five values of the truth and of the technique
  for (const Json& cell : results["cells"]) {
    const bool is_after = cell["row"] == "hard" && cell["value"] == 4;
    if (is_after) {
      EXPECT_EQ(cell["outcome"], "ok") << cell.dump();
    }
  }
}

TEST_F(Stress, BadInputIsRefusedBeforeAnythingIsRendered) {
  expect_bad_input(umbrameter({"stress", "nowhere.toml"}), "nowhere.toml");
  expect_bad_input(umbrameter({"stress", "--axis", "contact_gpa"}), "contact_gap");
  expect_bad_input(umbrameter({"stress", "--technique", "hrad"}), "hard");
  expect_bad_input(umbrameter({"stress", "--technique", "hard:map_size=64"}), "parameters");
  expect_bad_input(umbrameter({"stress", "--pictures"}), "--out");
}

}  // namespace
}  // namespace umbrameter
