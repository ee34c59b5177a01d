// SPDX-License-Identifier: Apache-2.0
// Without these, a renderer that integrates the light could be judged by geometric visibility: the truth itself would then
// be wrong, and a path tracer worse than a shadow map.

#include "tests/cli/cli_fixture.h"

#include "core/image_io.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class ScoreQuantity : public CliTest, public testing::WithParamInterface<const char*> {};

/// The truth's own pair, of another seed: E_unshadowed x S lit, E_unshadowed unlit.
TEST_P(ScoreQuantity, TheTruthsOwnPairHasNoErrorBeyondItsNoise) {
  const std::string scene = GetParam();
  for (const std::string seed : {"1", "2"}) {
    const ProcessResult result = umbrameter({"reference", scene, "--width", "160", "--height", "90", "--spp",
                                             "256", "--seed", seed, "-o", seed + ".exr"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  const Image other = read_image(folder() / "2.exr");
  Image lit(other.width, other.height), unlit(other.width, other.height);
  unlit.planes["Y"] = lit.planes["Y"] = other.planes.at("unshadowed_irradiance");
  const auto ratio = other.plane("irradiance_ratio");
  for (size_t i = 0; i < ratio.size(); ++i) lit.plane("Y")[i] *= ratio[i];
  write_exr(folder() / "lit.exr", lit);
  write_exr(folder() / "unlit.exr", unlit);
  const auto score = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"score", "--shadowed", "lit.exr", "--unshadowed", "unlit.exr", "--reference",
                               "1.exr", "--metrics", "error", "--json"});
    const ProcessResult result = umbrameter(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out);
  };
  const Json irradiance = score({"--quantity", "irradiance"}),
             visibility = score({"--quantity", "visibility"});
  // The noise of both: as much again as the reference's own, whose share is taken out.
  const auto truth = read_image(folder() / "1.exr");
  double variance = 0.0, pixels = 0.0;
  for (size_t i = 0; i < truth.pixel_count(); ++i) {
    if (truth.plane("unshadowed_irradiance")[i] <= 0.0f) continue;
    variance += std::pow(static_cast<double>(truth.plane("irradiance_ratio_se")[i]), 2);
    pixels += 1.0;
  }
  const double noise = std::sqrt(variance / pixels);
  // Nothing casts a shadow on the slanted plane: its truth is exact.
  EXPECT_TRUE(noise > 1e-5 || scene == "slanted_plane") << noise;
  EXPECT_LT(irradiance["error"]["rmse"]["value"].get<double>(), 2.0 * noise + 1e-4);
  EXPECT_LE(std::abs(irradiance["error"]["bias"].get<double>()), noise);
  // Nobody said which: the nearer one is taken, and the other one told.
  const Json both = score({});
  EXPECT_EQ(both["quantity"], std::abs(irradiance["error"]["rmse"]["value"].get<double>()) <
                                      std::abs(visibility["error"]["rmse"]["value"].get<double>())
                                  ? "irradiance"
                                  : "visibility");
}

// Every light type: rect, disk, sphere, sun.
INSTANTIATE_TEST_SUITE_P(Scenes, ScoreQuantity,
                         testing::Values("box_contact", "colonnade", "comb", "contact_hardening",
                                         "disk_occluder", "fence", "half_plane", "half_plane_disk", "plate",
                                         "slanted_plane", "sphere_terminator", "stacked_plates", "wire"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace umbrameter
