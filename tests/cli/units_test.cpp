// SPDX-License-Identifier: Apache-2.0
// Without these, the answer could depend on whether a scene was modelled in metres, centimetres or kilometres.

#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

/// Of a metre in the scene's unit.
constexpr std::array kScales = {0.01, 1.0, 1000.0};
const std::vector<std::string> kSmall = {"--width", "160", "--height", "90", "--spp", "64"};

class Units : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  /// A crate of 1 m on a floor of 6 m under a lamp 0.8 m wide.
  void write_crate(const std::string& name, double unit) const {
    const auto v = [unit](double x, double y, double z) {
      return fmt::format("[{}, {}, {}]", x * unit, y * unit, z * unit);
    };
    write(name, fmt::format(R"([camera]
eye = {}
at = {}
fov_deg = 45
[[mesh]]
shape = "plane"
size = [{}, {}]
[[mesh]]
shape = "box"
size = {}
[[light]]
type = "disk"
center = {}
at = [0, 0, 0]
radius = {}
)",
                            v(3.2, 2.4, 4.4), v(0, 0.4, 0), 6 * unit, 6 * unit, v(1, 1, 1), v(-3, 5, 2),
                            0.4 * unit));
  }

  Json answer(std::vector<std::string> arguments, const std::vector<std::string>& size = kSmall) const {
    arguments.insert(arguments.end(), size.begin(), size.end());
    arguments.insert(arguments.end(), {"--json"});
    const ProcessResult result = umbrameter(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out, nullptr, false);
  }
};

/// Faults of a run: pixels by class.
std::map<std::string, double> fault_pixels(const Json& run) {
  std::map<std::string, double> pixels;
  for (const auto& [name, share] : run["faults"]["classes"].items()) pixels[name] = share["pixels"];
  return pixels;
}

TEST_F(Units, ErrorsAndFaultsAreTheSameInEveryUnit) {
  std::vector<Json> runs;
  for (const double unit : kScales) {
    write_crate("crate.toml", unit);
    const Json json =
        answer({"validate", "crate.toml", "--frames", "0", "--out", fmt::format("out{}", unit), "--technique",
                "hard", "--technique", "pcss", "--technique", "vsm", "--technique",
                "pcss:penumbra_curve=squared", "--technique", "penumbra_mask:blur=distance_scaled",
                "--technique", fmt::format("hard:bias_world={}", 0.02 * unit)});
    runs.push_back(json["scenes"][0]["techniques"]);
  }
  ASSERT_EQ(runs[1].size(), 6u);
  for (const size_t other : {0u, 2u}) {
    for (size_t i = 0; i < runs[1].size(); ++i) {
      const Json &metres = runs[1][i], &here = runs[other][i];
      const std::string label = metres["label"];
      // A float rounds otherwise in another unit: a pixel or two of an outline fall to the other side.
      EXPECT_NEAR(here["error"]["rmse"]["value"], metres["error"]["rmse"]["value"], 2e-4) << label;
      for (const auto& [name, pixels] : fault_pixels(metres))
        EXPECT_NEAR(fault_pixels(here)[name], pixels, 3) << label << " " << name;
    }
  }
}

TEST_F(Units, SafeWindowsAndTunedValuesScaleWithTheUnit) {
  std::vector<Json> found;
  for (const double unit : kScales) {
    write_crate("crate.toml", unit);
    found.push_back(answer({"tune", "crate.toml", "--technique",
                            "hard:receiver_plane=none,bias_texels=0,normal_offset_texels=0,map_size=256",
                            "--parameters", "bias_world", "--evaluations", "12", "--cameras", "1", "--out",
                            fmt::format("tuned{}", unit)}));
  }
  const auto end = [&](size_t i, const char* name) {
    return found[i]["bias_sweep"][0][name]["world"].get<double>() / kScales[i];
  };
  ASSERT_TRUE(found[1]["bias_sweep"][0]["has_window"]);
  for (const size_t other : {0u, 2u}) {
    EXPECT_NEAR(std::log2(end(other, "acne_free_from") / end(1, "acne_free_from")), 0.0, 0.1);
    EXPECT_NEAR(std::log2(end(other, "peter_pan_free_to") / end(1, "peter_pan_free_to")), 0.0, 0.1);
    EXPECT_NEAR(found[other]["best"]["ratio"], found[1]["best"]["ratio"], 0.002);
    // Neighbouring biases have the same error: which is first among equals, rounding decides.
    const double tuned = found[other]["best"]["parameters"]["bias_world"].get<double>() / kScales[other];
    EXPECT_NEAR(std::log2(tuned / found[1]["best"]["parameters"]["bias_world"].get<double>()), 0.0, 0.6);
  }
}

TEST_F(Units, TheWindowOfACrateInCentimetresIsThatOfItsTexels) {
  write_crate("crate.toml", 100.0);
  const Json found =
      answer({"tune", "crate.toml", "--technique",
              "hard:receiver_plane=none,bias_texels=0,normal_offset_texels=0,map_size=512", "--parameters",
              "bias_world", "--evaluations", "3", "--cameras", "1", "--out", "tuned"},
             {"--width", "320", "--height", "180", "--spp", "64", "--no-coarse"});
  const Json& window = found["bias_sweep"][0];
  ASSERT_TRUE(window["has_window"]);
  // The front of the crate, of normal z, is the steepest that the lamp at (-3, 5, 2) lights: tangent of its incidence
  // sqrt(34) / 2, times half the diagonal of a texel: 2.06 texels. A thousandth of the pixels may have acne, and the levels
  // of the search are 13 % apart there.
  const double texels = window["acne_free_from"]["texels"].get<double>();
  EXPECT_NEAR(std::log2(texels / 2.06), 0.0, 0.25);
  EXPECT_NEAR(window["acne_free_from"]["world"].get<double>(), 3.3, 0.5);
  EXPECT_NEAR(window["peter_pan_free_to"]["world"].get<double>(), 69.0, 7.0);
}

TEST_F(Units, ABiasMayBeAsLongAsTheSceneIsLarge) {
  write_crate("crate.toml", 100.0);  // a diagonal of 854 cm
  const auto render = [&](const std::string& bias) {
    return umbrameter({"render", "crate.toml", "--technique", "hard:bias_world=" + bias, "--width", "32",
                       "--height", "18", "--json"});
  };
  const ProcessResult fine = render("2.02");
  ASSERT_EQ(fine.exit_code, 0) << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("bias_world=2.02"));
  EXPECT_THAT(render("0.01 diagonals").out, HasSubstr("bias_world=8.5"));
  expect_bad_input(render("500"),
                   "parameter 'bias_world' = 500 is outside its range [0, 427.2] in this scene");
}

}  // namespace
}  // namespace umbrameter
