// SPDX-License-Identifier: Apache-2.0
// Without these, a study could pass its parts' tests and not run.

#include "tests/cli/cli_fixture.h"

#include "core/files.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

constexpr const char* kHead =
    "schema = 1\ntitle = \"Tiny\"\nwidth_px = 64\nheight_px = 36\nsamples_per_pixel = 64\n";
constexpr const char* kRuns =
    "[[run]]\nlabel = \"hard\"\ntechnique = \"hard\"\n[run.values]\nmap_size = 64\n"
    "[[run]]\nlabel = \"wide, {stage.grid_taps}\"\ntechnique = \"pcf_bilinear\"\n[run.values]\nmap_size = "
    "64\n"
    "grid_taps = 15\nstage.grid_taps = [\"define\", \"uniform\"]\n"
    "[[claim]]\ntext = \"225 taps against one\"\nsource = \"here\"\nnumerator = \"wide, define\"\n"
    "denominator = \"hard\"\nunequal_cost = true\nquantity = \"time\"\nwithout = [\"map\"]\npaper = 10\n";

class BenchCommand : public CliTest {};
class GlBenchCommand : public CliTest {
 protected:
  void SetUp() override { require_gl(); }
};

TEST_F(GlBenchCommand, RunsAStudyAndWritesItsNumbers) {
  std::filesystem::create_directory(folder() / "study");
  write_scene("study/scene.toml");
  write("study/study.toml", std::string(kHead) + "scenes = [\"scene.toml\"]\nframes = 8\n" + kRuns);
  const ProcessResult result =
      umbrameter({"bench", "study/study.toml", "--json", "--csv", "runs.csv", "--truth", "truth.csv",
                  "--best-under", "10 s", "--cheapest-below-rmse", "0.9"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  const Json& scene = json["scenes"][0];
  EXPECT_EQ(scene["name"], "scene.toml");
  ASSERT_EQ(scene["runs"].size(), 3u);
  EXPECT_EQ(scene["runs"][2]["parameters"]["stage.grid_taps"], "uniform");
  for (const Json& run : scene["runs"]) {
    EXPECT_EQ(run["pass_times"].back()["frames"], 8);
    EXPECT_FALSE(run["rmse"].is_null());
    EXPECT_EQ(json["note"], run["is_software"] ? "software rasteriser: ratios are not a GPU's" : "");
  }
  // 225 taps cost more than one by far more than any noise.
  EXPECT_EQ(scene["claims"][0]["verdict"], "same order") << scene["claims"][0];
  EXPECT_EQ(scene["claims"][0]["compares_per_pixel"], (Json{900, 1})) << "225 taps of four texels";
  EXPECT_FALSE(scene["best_under"].empty());
  EXPECT_FALSE(scene["cheapest_below_rmse"].empty());
  const std::string csv = read_file(folder() / "runs.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3);
  ASSERT_EQ(scene["truth"]["points"].size(), 8u);
  for (const char* key : {"setting", "cpu_s", "cpu_mad_s", "rays_per_pixel", "rmse", "rmse_low", "rmse_high"})
    EXPECT_TRUE(scene["truth"]["points"][0][key].is_number()) << key;
  EXPECT_LT(scene["truth"]["exponent"], -0.5);
  EXPECT_EQ(std::ranges::count(read_file(folder() / "truth.csv"), '\n'), 1 + 8);
  EXPECT_THAT(files(), ElementsAre("runs.csv", "study", "truth.csv"));
}

TEST_F(GlBenchCommand, PrintsTablesAndClaims) {
  write("study.toml", std::string(kHead) + "scenes = [\"plate\"]\nframes = 6\n" + kRuns);
  const ProcessResult result = umbrameter({"bench", "study.toml", "--frames", "7", "--passes"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* part : {"Tiny\n64 x 36 px, 64 samples per pixel", "wide, uniform", "on the front", "paper",
                           "verdict", "225 taps against one", "(7 frames)"})
    EXPECT_THAT(result.out, HasSubstr(part));
}

TEST_F(GlBenchCommand, TruthsAndRunsAreRenderedOnceAStore) {
  write_scene("scene.toml");
  write("study.toml",
        std::string(kHead) +
            "scenes = [\"scene.toml\"]\nframes = 2\n[[camera]]\nname = "
            "\"own\"\n[[camera]]\nname = \"side\"\norbit_deg = 15\n[[run]]\ntechnique = \"hard\"\n");
  constexpr const char *kTruths = "its truth is stored", *kAll = "its runs and their times are stored";
  const auto bench = [&](const std::vector<std::string>& more, const std::string& reused) {
    std::vector<std::string> arguments = {"bench", "study.toml", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = umbrameter(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.find("2 truths reused, about ") != std::string::npos, reused == kTruths)
        << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["skipped"].size(), reused.empty() ? 0 : 2);
    for (const Json& skip : json["skipped"]) {
      EXPECT_EQ(skip["reason"], reused);
      EXPECT_TRUE(skip["saved_s"].is_number());
    }
    Json numbers;
    for (const Json& scene : json["scenes"])
      numbers.push_back({scene["name"], scene["reference_device"], scene["parity"],
                         scene["runs"][0]["error"]["rmse"], scene["runs"][0]["error"]["bias"]});
    return numbers;
  };
  const Json alone = bench({}, "");
  EXPECT_THAT(files(), ElementsAre("scene.toml", "study.toml"));
  EXPECT_NE(alone[0][3], alone[1][3]);  // two cameras
  EXPECT_EQ(bench({"--out", "out"}, ""), alone);
  EXPECT_EQ(bench({"--out", "out"}, kAll), alone);
  EXPECT_EQ(bench({"--out", "out", "--frames", "3"}, kTruths), alone) << "times of as many frames";
  EXPECT_EQ(bench({"--out", "out", "--no-reuse"}, ""), alone);
  const ProcessResult sweep = umbrameter({"sweep", "study.toml", "--time", "--out", "out", "--json"});
  EXPECT_EQ(Json::parse(sweep.out)["references_rendered"], 0) << sweep.err;
  EXPECT_EQ(Json::parse(sweep.out)["rendered"], 0) << "bench has scored and timed them";
}

TEST_F(BenchCommand, SlipsAreFoundBeforeAnythingIsRendered) {
  const auto study = [&](const std::string& runs) {
    write("study.toml", std::string(kHead) + "scenes = [\"plate\"]\n" + runs);
    return umbrameter({"bench", "study.toml"});
  };
  // Five lines of head, scenes, [[run]], technique, [run.values]: values stand in line 10.
  const std::string run = "[[run]]\ntechnique = \"pcf_bilinear\"\n";
  expect_bad_input(study("[[run]]\ntechnique = \"pcff\"\n"), "pcff");
  expect_bad_input(study(run + "[run.values]\ngrid_tap = 3\n"),
                   "study.toml:10:12: technique 'pcf_bilinear' has no "
                   "parameter 'grid_tap' (did you mean 'grid_taps'?)");
  expect_bad_input(study(run + "[run.values]\ngrid_taps = [3, 99]\n"), "study.toml:10:17:");
  expect_bad_input(study(run + "[run.values]\nstage.spacing_texels = \"define\"\n"), "cannot be switched");
  expect_bad_input(study(run + "preset = \"nothing\"\n"), "has no preset 'nothing'");
  const std::string claim =
      run +
      "[[run]]\ntechnique = \"hard\"\n[[claim]]\ntext = \"t\"\nsource = \"s\"\nnumerator = \"hard\"\n"
      "denominator = \"pcf_bilinear\"\nquantity = \"fps\"\nat_least = 1\n";
  expect_bad_input(study(claim), "'hard' 1 and 'pcf_bilinear' 36 comparisons per pixel");
  expect_bad_input(study("quality = \"quik\"\n" + run), "unknown quality 'quik' (did you mean 'quick'?)");
  write("study.toml", std::string(kHead) + "scenes = [\"plat\"]\n" + run);
  expect_bad_input(umbrameter({"bench", "study.toml"}), "plat");
  expect_bad_input(umbrameter({"bench", "nowhere.toml"}), "nowhere.toml");
}

TEST_F(BenchCommand, TheStudiesOfPapersNameTechniquesThatExist) {
  // Techniques, parameters and the costs of claims are known before scenes are loaded: only the models are missing here.
  const std::filesystem::path papers = source_dir() / "studies" / "papers";
  int studies = 0;
  for (const auto& file : std::filesystem::directory_iterator(papers)) {
    expect_bad_input(umbrameter({"bench", file.path().string()}), "UMBRAMETER_ASSETS");
    ++studies;
  }
  EXPECT_EQ(studies, 6);
}

TEST_F(BenchCommand, TimesNeedUnitsAndCsvItsName) {
  write("study.toml", std::string(kHead) + "scenes = [\"plate\"]\n" + kRuns);
  expect_bad_input(umbrameter({"bench", "study.toml", "--best-under", "1"}), "such as 1ms");
  expect_bad_input(umbrameter({"bench", "study.toml", "--best-under", "-1ms"}), "not a time");
  expect_bad_input(umbrameter({"bench", "study.toml", "--cheapest-below-rmse", "0"}), "not positive");
  expect_bad_input(umbrameter({"bench", "study.toml", "--no-reuse"}), "needs --out");
  expect_bad_input(umbrameter({"bench", "study.toml", "--csv", "runs.txt"}), "does not end in '.csv'");
  expect_bad_input(umbrameter({"bench", "study.toml", "--truth", "truth.json"}), "does not end in '.csv'");
}

}  // namespace
}  // namespace umbrameter
