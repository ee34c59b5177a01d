// SPDX-License-Identifier: Apache-2.0
// Without these tests a command could stop working end to end, mix logs into its JSON, or exit with the wrong
// code.

#include "tests/cli/cli_fixture.h"

#include "core/files.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>

namespace umbrameter {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::json;

const std::vector<std::string> kTiny{"--width", "64", "--height", "36", "--spp", "64"};

std::vector<std::string> with_tiny(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), kTiny.begin(), kTiny.end());
  return arguments;
}

class Commands : public CliTest {};
class GlCommands : public CliTest {
 protected:
  void SetUp() override { require_gl(); }
};

TEST_F(Commands, HelpAndVersionSucceed) {
  EXPECT_EQ(umbrameter({"--help"}).exit_code, 0);
  EXPECT_EQ(umbrameter({"validate", "--help"}).exit_code, 0);
  EXPECT_THAT(umbrameter({"--version"}).out, testing::StartsWith("umbrameter 0."));
}

TEST_F(Commands, ListsAreOneJsonObject) {
  const ProcessResult scenes = umbrameter({"scene", "list", "--json"});
  EXPECT_EQ(scenes.exit_code, 0);
  EXPECT_GE(Json::parse(scenes.out)["scenes"].size(), 13u);
  const Json techniques = Json::parse(umbrameter({"--json", "techniques"}).out)["techniques"];
  std::vector<std::string> ids;
  for (const Json& technique : techniques) ids.push_back(technique["id"]);
  for (const char* id : {"hard", "pcf", "pcss", "accumulate"}) EXPECT_THAT(ids, Contains(id));
}

TEST_F(Commands, APlanNamesWhatRunsAndWhatIsSkippedAndWhy) {
  // Fence has a sphere light: techniques of a flat light's points or of the sun alone have nothing to do there.
  const Json plan =
      Json::parse(umbrameter({"scene", "plan", "fence", "--quality", "quick", "--json"}).out)["scenes"][0];
  EXPECT_EQ(plan["most_shadow_rays"], 480 * 270 * 256);
  EXPECT_THAT(std::vector<std::string>(plan["runs"]), Contains("pcss"));
  std::vector<std::string> skipped;
  for (const Json& skip : plan["skips"]) skipped.push_back(skip["technique"]);
  std::vector<std::string> without_sphere;
  const Json techniques = Json::parse(umbrameter({"techniques", "--json"}).out)["techniques"];
  for (const Json& technique : techniques) {
    if (std::ranges::find(technique["lights"], Json("sphere")) == technique["lights"].end())
      without_sphere.push_back(technique["id"]);
  }
  EXPECT_THAT(skipped, testing::IsSupersetOf({"accumulate", "planar", "pcss_cascades"}));
  EXPECT_EQ(skipped, without_sphere);
  EXPECT_EQ(plan["skips"][0]["reason"], "does not support sphere lights");
}

TEST_F(Commands, ShowPrintsEveryParameterWithItsRange) {
  const Json technique = Json::parse(umbrameter({"techniques", "show", "pcss", "--json"}).out);
  const std::string text = umbrameter({"techniques", "show", "pcss"}).out;
  ASSERT_FALSE(technique["parameters"].empty());
  for (const Json& parameter : technique["parameters"])
    EXPECT_THAT(text, HasSubstr(std::string(parameter["name"])));
}

TEST_F(Commands, AReferenceScoredAgainstItselfHasItsOwnNoiseAsError) {
  ASSERT_EQ(umbrameter(with_tiny({"reference", "plate", "-o", "ref.exr"})).exit_code, 0);
  EXPECT_THAT(files(), ElementsAre("ref.exr"));
  const ProcessResult result = umbrameter({"score", "ref.exr", "--reference", "ref.exr", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json score = Json::parse(result.out);
  EXPECT_EQ(score["parity"]["agreement"], 1.0);
  EXPECT_EQ(score["error"]["bias"], 0.0);
  EXPECT_EQ(score["error"]["mae"], 0.0);
}

TEST_F(Commands, ScoringAnotherSceneFailsTheGate) {
  ASSERT_EQ(umbrameter(with_tiny({"reference", "plate", "-o", "plate.exr"})).exit_code, 0);
  ASSERT_EQ(umbrameter(with_tiny({"reference", "colonnade", "-o", "columns.exr"})).exit_code, 0);
  const ProcessResult result = umbrameter({"score", "columns.exr", "--reference", "plate.exr"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("FAILS"));
}

TEST_F(Commands, MissingAssetsAreSkippedLoudlyInTheList) {
  EXPECT_THAT(umbrameter({"scene", "list"}).out, HasSubstr("assets missing"));
}

TEST_F(Commands, WithoutGlTheMessageSaysWhichPackage) {
  const ProcessOptions no_gl{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}}};
  for (const std::string verb : {"doctor", "validate"}) {
    const ProcessResult result = umbrameter({verb}, no_gl);
    EXPECT_EQ(result.exit_code, 3) << result.err;
    EXPECT_THAT(last_line(result.err), HasSubstr("libegl1"));
  }
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Commands, AnInstallationWithoutScenesIsAnEnvironmentError) {
  const ProcessResult result =
      umbrameter({"scene", "list"}, {.environment = {{"UMBRAMETER_HOME", "/nowhere"}}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("UMBRAMETER_HOME '/nowhere' has no scenes/library"));
}

TEST_F(Commands, ACopiedProgramDoesNotReadTheFolderItWasBuiltIn) {
  std::filesystem::create_directories(folder() / "copy/bin");
  std::filesystem::copy(program_path(), folder() / "copy/bin/umbrameter");
  const ProcessResult result = run_process({(folder() / "copy/bin/umbrameter").string(), "scene", "list"},
                                           {.environment = {{"UMBRAMETER_HOME", ""}}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("copy/share/umbrameter' is not there"));
}

TEST_F(Commands, InterruptionLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ProcessResult result = umbrameter(
        {"reference", "colonnade", "--quality", "full", "--spp", "65536", "-o", "made/for/ref.exr"},
        {.timeout_s = 60, .signal = signal, .signal_after_ms = 1500});
    EXPECT_EQ(result.exit_code, 128 + signal) << result.err;
    EXPECT_THAT(result.err, HasSubstr("interrupted"));
    EXPECT_THAT(files(), IsEmpty());
  }
}

TEST_F(GlCommands, ValidateWritesImagesResultsAndReport) {
  write_scene("my.toml");
  const ProcessResult result =
      umbrameter(with_tiny({"validate", "my.toml", "--technique", "hard:map_size=512", "--technique",
                            "pcf:preset=low", "--json"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json results = Json::parse(result.out);
  ASSERT_EQ(results["scenes"].size(), 1u);
  const Json& scene = results["scenes"][0];
  EXPECT_EQ(scene["name"], "my");
  EXPECT_TRUE(scene["parity"]["passes"]);
  ASSERT_EQ(scene["techniques"].size(), 2u);
  EXPECT_EQ(scene["techniques"][0]["label"], "hard:map_size=512");
  EXPECT_EQ(scene["techniques"][0]["parameters"]["map_size"], 512);
  for (const char* key : {"image_file", "picture_file", "error_picture_file"}) {
    EXPECT_TRUE(std::filesystem::exists(folder() / "out" / std::string(scene["techniques"][0][key]))) << key;
  }
  EXPECT_TRUE(std::filesystem::exists(folder() / "out/report.html"));
  EXPECT_THAT(files(), ElementsAre("my.toml", "out"));
  // The stored images give the same score again.
  const std::string image = "out/" + std::string(scene["techniques"][1]["image_file"]);
  const std::string reference = "out/" + std::string(scene["reference"]["image_file"]);
  const Json again = Json::parse(umbrameter({"score", image, "--reference", reference, "--json"}).out);
  EXPECT_EQ(again["error"]["rmse"], scene["techniques"][1]["error"]["rmse"]);
  // A second validation replaces the first.
  ASSERT_EQ(umbrameter(with_tiny({"validate", "plate", "--technique", "hard"})).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder() / "out/images/my"));
  EXPECT_TRUE(std::filesystem::exists(folder() / "out/images/plate/hard.exr"));
}

TEST_F(GlCommands, AShaderThatDoesNotCompileIsNamedWithItsLineAndNothingIsWritten) {
  const std::filesystem::path source = source_dir() / "realtime/techniques/hard";
  std::filesystem::copy(source, folder() / "mine");
  std::string text = read_file(source / "hard.frag");
  const size_t body = text.find("void main() {");
  ASSERT_NE(body, std::string::npos);
  text.insert(body, "int broken = ;\n");
  write("mine/hard.frag", text);
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(body), '\n');
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"techniques", "check", "./mine"},
        with_tiny({"render", "plate", "--technique", "./mine"}),
        with_tiny({"validate", "plate", "--technique", "./mine"})}) {
    const ProcessResult result = umbrameter(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("mine/hard.frag:" + std::to_string(line)));
    EXPECT_THAT(files(), ElementsAre("mine"));
  }
}

TEST_F(GlCommands, AUsersFolderRunsBesideTheBuiltInTechnique) {
  const std::filesystem::path source = source_dir() / "realtime/techniques/hard";
  std::filesystem::copy(source, folder() / "mine");
  const ProcessResult result =
      umbrameter(with_tiny({"validate", "plate", "--technique", "hard", "--technique", "./mine", "--json"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json techniques = Json::parse(result.out)["scenes"][0]["techniques"];
  EXPECT_EQ(techniques[1]["label"], "./mine");
  EXPECT_EQ(techniques[0]["error"]["rmse"],
            techniques[1]["error"]["rmse"]);  // the same files, the same number
}

TEST_F(GlCommands, TraitsOfScenesThatATechniqueCannotLightAreNotMeasured) {
  const Json answer =
      Json::parse(umbrameter({"techniques", "traits", "hard", "hard_cascades", "--json"}).out);
  const Json &hard = answer["traits"][0], &cascades = answer["traits"][1];
  for (const char* trait : {"precise", "soft", "anti-aliased", "noise-free"}) {
    EXPECT_TRUE(hard[trait]["value"].is_number()) << trait;
    EXPECT_TRUE(cascades[trait]["value"].is_null())
        << trait;  // a disk or a rect light; cascades are the sun's
    EXPECT_TRUE(cascades[trait]["verdict"].is_null()) << trait;
  }
  EXPECT_TRUE(cascades["acne-free"]["value"].is_number());  // slanted_plane has a sun
  EXPECT_EQ(cascades["failure"], "");
}

TEST_F(GlCommands, DoctorNamesDeviceTimerAndVersions) {
  const Json found = Json::parse(umbrameter({"doctor", "--json"}).out);
  EXPECT_FALSE(found["gl_devices"].empty());
  EXPECT_NE(found["timer"], "");
  EXPECT_THAT(std::string(found["reference_device"]), HasSubstr("Embree"));
}

}  // namespace
}  // namespace umbrameter
