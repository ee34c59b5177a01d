// SPDX-License-Identifier: Apache-2.0
// Without these, a picture of another engine could be scored with other numbers than the same picture of ours: its transfer
// undone wrongly, its pairs divided wrongly, its places not looked at.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class YourEngine : public CliTest {
 protected:
  const std::vector<std::string> size_ = {"--width", "192", "--height", "108", "--spp", "128"};

  ProcessResult run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), size_.begin(), size_.end());
    return umbrameter(arguments);
  }

  // "hard" on one scene, rendered as any program would, and pairs made from it by oiiotool.
  void SetUp() override {
    require_gl();
    if (IsSkipped()) return;
    const ProcessResult rendered =
        run({"render", "plate", "--technique", "hard:map_size=512", "-o", "ours.exr"});
    ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
    const ProcessResult truth = run({"reference", "plate", "-o", "truth.exr"});
    ASSERT_EQ(truth.exit_code, 0) << truth.err;
    // Brightest about .9: irradiance of a light of unit radiance stays below pi.
    oiio({"ours.exr", "--ch", "Y=unshadowed_irradiance", "--mulc", scale(), "-o", "u.exr"});
    oiio({"ours.exr", "--ch", "Y=visibility", "u.exr", "--mul", "-o", "s.exr"});
    for (const std::string name : {"s", "u"}) {
      oiio({name + ".exr", "--powc", "0.45454545", "-d", "uint8", "-o", name + "_gamma.png"});
      oiio({name + ".exr", "--ch", "R=Y,G=Y,B=Y", "--colorconvert", "linear", "sRGB", "-d", "uint8", "-o",
            name + "_srgb.png"});
    }
  }

  void oiio(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {"oiiotool"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ProcessOptions options;
    options.working_folder = folder();
    const ProcessResult result = run_process(command, options);
    ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
  }

  std::string scale() const {
    ProcessOptions options;
    options.working_folder = folder();
    const ProcessResult result =
        run_process({"oiiotool", "ours.exr", "--ch", "unshadowed_irradiance", "--printstats"}, options);
    const size_t at = result.out.find("Stats Max:");
    EXPECT_NE(at, std::string::npos) << result.out;
    return std::to_string(0.9 / std::stod(result.out.substr(at + 10)));
  }

  ProcessResult score(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {"score"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return umbrameter(command);
  }

  // What validate says of the same technique against the same truth.
  Json validated() const {
    const ProcessResult result =
        run({"validate", "plate", "--technique", "hard:map_size=512", "--frames", "0", "-o", "validated"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::ifstream file(folder() / "validated" / "results.json");
    return Json::parse(file)["scenes"][0]["techniques"][0];
  }
};

TEST_F(YourEngine, APairOfFloatsScoresAsTheTechniqueDoes) {
  const Json ours = validated();
  const ProcessResult result =
      score({"--shadowed", "s.exr", "--unshadowed", "u.exr", "--reference", "truth.exr", "--surfaces",
             "ours.exr", "--quantity", "visibility", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_TRUE(json["parity"]["passes"]);
  const double expected = ours["error"]["rmse"]["value"];
  EXPECT_NEAR(json["error"]["rmse"]["value"].get<double>(), expected, 1e-3 * expected);
  EXPECT_EQ(json["faults"]["worst"], ours["faults"]["worst"]);
  EXPECT_EQ(json["mean_square_rounding"], 0.0);
}

TEST_F(YourEngine, EightBitsCostNoMoreThanTheySay) {
  // Squared errors are added up: pixels too dark for a ratio are left out, and have none here.
  const Json ours = validated()["error"];
  const auto sum = [](const Json& error) {
    return error["mse"]["value"].get<double>() * error["scored_pixels"].get<double>();
  };
  for (const auto& [suffix, transfer] : {std::pair{"_gamma.png", "gamma2.2"}, {"_srgb.png", "srgb"}}) {
    const ProcessResult result =
        score({"--shadowed", std::string("s") + suffix, "--unshadowed", std::string("u") + suffix,
               "--transfer", transfer, "--reference", "truth.exr", "--surfaces", "ours.exr", "--quantity",
               "visibility", "--min-scored", "0.8", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    const double rounding = json["mean_square_rounding"], pixels = json["error"]["scored_pixels"];
    EXPECT_GT(rounding, 1e-7) << transfer;
    EXPECT_LT(rounding, 0.125 * 0.125 / 12.0)
        << transfer;  // of the darkest pixels that count: two steps of 1/16
    EXPECT_GT(pixels, 0.8 * ours["scored_pixels"].get<double>()) << transfer;
    EXPECT_NEAR(sum(json["error"]), sum(ours), rounding * pixels + 0.005 * sum(ours)) << transfer;
    EXPECT_THAT(result.err, HasSubstr("steps are up to")) << transfer;
  }
}

TEST_F(YourEngine, SaysWhatItCannotKnow) {
  const std::vector<std::string> pair = {"--shadowed", "s.exr",       "--unshadowed",
                                         "u.exr",      "--reference", "truth.exr"};
  const ProcessResult result = score(pair);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no surface channels: not known"));
  EXPECT_THAT(result.out, HasSubstr("parity           not checked"));
  oiio({"ours.exr", "--flip", "--ch", "Y=visibility", "-o", "flipped.exr"});
  EXPECT_THAT(score({"flipped.exr", "--reference", "truth.exr"}).err,
              HasSubstr("when it is read upside down"));
}

TEST_F(YourEngine, RefusesWhatSaysNothing) {
  expect_bad_input(
      score({"--shadowed", "s_srgb.png", "--unshadowed", "u_srgb.png", "--reference", "truth.exr"}),
      "--transfer");
  expect_bad_input(score({"--shadowed", "s.exr", "--reference", "truth.exr"}), "go together");
  oiio({"s.exr", "--resize", "96x54", "-o", "small.exr"});
  expect_bad_input(score({"small.exr", "--reference", "truth.exr"}), "96 x 54 px");
  expect_bad_input(score({"s.exr"}), "--scene NAME");
}

TEST_F(YourEngine, ASceneRendersItsOwnTruthAndAReport) {
  const ProcessResult result = score({"ours.exr", "--scene", "plate", "--spp", "64", "-o", "scored"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::ifstream file(folder() / "scored" / "results.json");
  const Json json = Json::parse(file);
  EXPECT_EQ(json["scenes"][0]["name"], "plate");
  EXPECT_FALSE(json["scenes"][0]["techniques"][0]["error"].is_null());
  const ProcessResult report = umbrameter({"report", "scored", "-o", "again.html"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
}

TEST_F(YourEngine, SurfacesOfAnotherCameraFailParity) {
  write_scene("moved.toml");
  const ProcessResult rendered = run({"reference", "moved.toml", "-o", "moved.exr"});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
  oiio({"moved.exr", "--ch", "position.x,position.y,position.z", "-o", "places.exr"});
  const ProcessResult result = score({"s.exr", "--reference", "truth.exr", "--surfaces", "places.exr"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("show other surfaces"));
}

TEST_F(YourEngine, ExportedMatricesAreThoseOfThePicture) {
  const ProcessResult result =
      umbrameter({"scene", "export", "plate", "--width", "192", "--height", "108", "-o", "e"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::ifstream file(folder() / "e" / "scene.json");
  const Json json = Json::parse(file);
  // What the camera looks at lies in the middle of the picture.
  const Json at = json["camera"]["at_world"], m = json["camera"]["clip_from_world"];
  const auto row = [&](size_t k) {
    return m[k][0].get<double>() * at[0].get<double>() + m[k][1].get<double>() * at[1].get<double>() +
           m[k][2].get<double>() * at[2].get<double>() + m[k][3].get<double>();
  };
  EXPECT_NEAR(row(0) / row(3), 0.0, 1e-9);
  EXPECT_NEAR(row(1) / row(3), 0.0, 1e-9);
  EXPECT_GT(row(3), 0.0);
  std::ifstream mesh(folder() / "e" / "scene.obj");
  size_t faces = 0;
  for (std::string text; std::getline(mesh, text);) faces += text.starts_with("f ") ? 1 : 0;
  EXPECT_EQ(faces, json["triangles"].get<size_t>());
}

}  // namespace
}  // namespace umbrameter
