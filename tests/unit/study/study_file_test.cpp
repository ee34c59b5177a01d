// SPDX-License-Identifier: Apache-2.0
// Without these, a study with a slip would measure something else than it says.

#include "study/study_file.h"

#include "core/error.h"
#include "core/files.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kHead = "schema = 1\ntitle = \"t\"\nscenes = [\"plate\", \"assets/bunny\"]\n";
constexpr const char* kRuns =
    "[[run]]\nlabel = \"a\"\ntechnique = \"hard\"\n[[run]]\nlabel = \"b\"\ntechnique = \"pcf\"\n";

StudyFile parse(const std::string& body) {
  return parse_study(kHead + body, "study.toml");
}

std::string error_of(const std::string& body) {
  try {
    parse(body);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::string> labels(const StudyFile& study) {
  std::vector<std::string> texts;
  for (const StudyRun& run : study.runs) texts.push_back(run.label);
  return texts;
}

std::string run_with(const std::string& values, const std::string& label = "x") {
  return "[[run]]\nlabel = \"" + label + "\"\ntechnique = \"pcf\"\n[run.values]\n" + values + "\n";
}

std::vector<double> numbers(const std::string& values) {
  std::vector<double> result;
  for (const StudyRun& run : parse(run_with("v = " + values)).runs)
    result.push_back(run.values[0].second.real);
  return result;
}

TEST(StudyFileTest, CamerasTurnOrReplaceTheScenesOwn) {
  EXPECT_TRUE(parse(kRuns).cameras.empty());
  const StudyFile study = parse(
      "[[camera]]\nname = \"own\"\n[[camera]]\nname = \"around\"\norbit_deg = [-20, 7.5]\n[[camera]]\nname = "
      "\"door\"\neye = [1, 2, 3]\nat = [0, 0, 0]\nfov_deg = 60\n" +
      std::string(kRuns));
  std::vector<std::string> names;
  for (const StudyCamera& camera : study.cameras) names.push_back(camera.name);
  EXPECT_THAT(names, ElementsAre("own", "around -20 deg", "around +7.5 deg", "door"));
  Camera own;
  own.eye_world = {10, 1, 0};
  own.at_world = {0, 1, 0};
  own.vertical_fov_deg = 30;
  EXPECT_EQ(camera_in(study.cameras[0], own).eye_world, own.eye_world);
  const Camera turned = camera_in(study.cameras[1], own);
  // Around +y by -20 degrees: x to x cos 20, z to x sin 20.
  EXPECT_NEAR(turned.eye_world.x, 9.397, 1e-3);
  EXPECT_NEAR(turned.eye_world.y, 1.0, 1e-12);
  EXPECT_NEAR(turned.eye_world.z, 3.420, 1e-3);
  EXPECT_EQ(turned.vertical_fov_deg, 30);
  EXPECT_EQ(camera_in(study.cameras[3], own).eye_world, glm::dvec3(1, 2, 3));
  EXPECT_EQ(camera_in(study.cameras[3], own).vertical_fov_deg, 60);
}

TEST(StudyFileTest, SlipsInCamerasAreNamedAtTheirPlace) {
  const auto slip = [](const std::string& camera) { return error_of("[[camera]]\n" + camera + kRuns); };
  EXPECT_THAT(slip("orbit_deg = 1\n"), HasSubstr("study.toml:4"));
  EXPECT_THAT(slip("name = \"\"\n"), HasSubstr("name is empty"));
  EXPECT_THAT(slip("name = \"a\"\norbit_dg = 3\n"), HasSubstr("did you mean 'orbit_deg'?"));
  EXPECT_THAT(slip("name = \"a\"\norbit_deg = 360\n"), HasSubstr("no angle between"));
  EXPECT_THAT(slip("name = \"a\"\norbit_deg = []\n"), HasSubstr("is empty"));
  EXPECT_THAT(slip("name = \"a\"\norbit_deg = 3\neye = [0, 0, 1]\n"), HasSubstr("there is no other place"));
  EXPECT_THAT(slip("name = \"a\"\neye = [0, 0, 1]\n"), HasSubstr("'at'"));
  EXPECT_THAT(slip("name = \"a\"\n[[camera]]\nname = \"a\"\n"), HasSubstr("two cameras are called 'a'"));
}

TEST(StudyFileTest, LightsAreOneOrAList) {
  EXPECT_TRUE(parse(kRuns).lights.empty());
  EXPECT_THAT(parse("light = \"sky\"\n" + std::string(kRuns)).lights, ElementsAre("sky"));
  EXPECT_THAT(parse("light = [\"sky\", \"2\"]\n" + std::string(kRuns)).lights, ElementsAre("sky", "2"));
  EXPECT_THAT(error_of("light = [\"sky\", \"sky\"]\n" + std::string(kRuns)),
              HasSubstr("light 'sky' is given twice"));
  EXPECT_THAT(error_of("light = []\n" + std::string(kRuns)), HasSubstr("'light' is an empty list"));
}

TEST(StudyFileTest, AClaimOfASceneIsOneOfEachOfItsLights) {
  Claim claim;
  claim.by_scene = {{"plate", {2.0, 2.0}}, {"plate/sky", {3.0, 3.0}}};
  EXPECT_EQ(paper_ratio(claim, "plate/sky")->low, 3.0) << "its own comes first";
  EXPECT_EQ(paper_ratio(claim, "plate/lamp")->low, 2.0);
  EXPECT_FALSE(paper_ratio(claim, "plates").has_value());
}

TEST(StudyFileTest, SeveralQualitiesHaveNoSizeOfTheirOwn) {
  EXPECT_THAT(parse("quality = [\"quick\", \"full\"]\n" + std::string(kRuns)).qualities,
              ElementsAre("quick", "full"));
  const auto slip = [](const std::string& keys) { return error_of(keys + kRuns); };
  EXPECT_THAT(slip("quality = []\n"), HasSubstr("study.toml:4"));
  EXPECT_THAT(slip("quality = [\"full\", \"full\"]\n"), HasSubstr("'full' is given twice"));
  EXPECT_THAT(slip("quality = 3\n"), HasSubstr("quality"));
  EXPECT_THAT(slip("quality = [\"quick\", \"full\"]\ntarget_se = 0.1\n"),
              HasSubstr("'target_se' goes with one quality"));
}

TEST(StudyFileTest, DefaultsAndNumbers) {
  const StudyFile study = parse(kRuns);
  EXPECT_THAT(study.scenes, ElementsAre("plate", "assets/bunny"));
  EXPECT_EQ(study.qualities, std::vector<std::string>{"quick"});
  EXPECT_EQ(study.frames, 30);
  EXPECT_THAT(study.seeds, ElementsAre(1u));
  const StudyFile other = parse(
      "quality = \"full\"\nwidth_px = 64\nheight_px = 36\nsamples_per_pixel = 32\ntarget_se = 0.01\nseeds = "
      "[3, 4]\n"
      "frames = 9\nframe_budget_s = 0.5\ndoc = \"d\"\n" +
      std::string(kRuns));
  EXPECT_THAT(other.qualities, ElementsAre("full"));
  EXPECT_EQ(other.width_px, 64);
  EXPECT_EQ(other.samples_per_pixel, 32);
  EXPECT_EQ(other.target_se, 0.01);
  EXPECT_THAT(other.seeds, ElementsAre(3u, 4u));
  EXPECT_EQ(other.frames, 9);
  EXPECT_EQ(other.frame_budget_s, 0.5);
}

TEST(StudyFileTest, ListsMultiplyAndTheLabelSaysWhichPoint) {
  const StudyFile study =
      parse(run_with("taps = [3, 5]\nfit = [\"scene\", \"visible\"]\nsize = 512", "pcf {taps}"));
  EXPECT_THAT(labels(study),
              ElementsAre("pcf 3 fit=scene", "pcf 3 fit=visible", "pcf 5 fit=scene", "pcf 5 fit=visible"));
  const StudyRun& last = study.runs[3];
  EXPECT_EQ(last.technique, "pcf");
  EXPECT_EQ(last.values[0].first, "taps");
  EXPECT_EQ(last.values[0].second.integer, 5);
  EXPECT_EQ(last.values[1].second.text, "visible");
  EXPECT_EQ(last.values[2].second.integer, 512);
}

TEST(StudyFileTest, StagesMayBeWrittenWithOrWithoutQuotes) {
  for (const std::string key : {"stage.taps", "\"stage.taps\""}) {
    const StudyFile study = parse(run_with(key + " = [\"define\", \"uniform\"]", "{stage.taps}"));
    EXPECT_THAT(labels(study), ElementsAre("define", "uniform"));
    EXPECT_EQ(study.runs[0].values[0].first, "stage.taps");
  }
}

TEST(StudyFileTest, RangesHaveTheirEndsAndLogarithmicStepsEqualRatios) {
  EXPECT_THAT(numbers("{ range = [3, 9, 2] }"), ElementsAre(3, 5, 7, 9));
  EXPECT_EQ(numbers("{ range = [0.0, 0.3, 0.1] }").size(), 4u);
  EXPECT_THAT(numbers("{ log = [512, 4096, 4] }"), ElementsAre(512, 1024, 2048, 4096));
  const StudyFile study = parse(run_with("v = { log = [1, 10, 3] }"));
  EXPECT_EQ(study.runs[0].values[0].second.type, TomlNode::Type::integer);
  EXPECT_EQ(study.runs[1].values[0].second.type,
            TomlNode::Type::real);  // for an integer parameter an error later
  EXPECT_NEAR(study.runs[1].values[0].second.real, std::sqrt(10.0), 1e-12);
  EXPECT_EQ(parse(run_with("v = { range = [0.0, 1.0, 1.0] }")).runs[0].values[0].second.type,
            TomlNode::Type::real);
}

TEST(StudyFileTest, ClaimsHoldOneNumberARangeOrOnePerScene) {
  const std::string head =
      "[[claim]]\ntext = \"t\"\nsource = \"A\"\nnumerator = \"a\"\ndenominator = \"b\"\n";
  const StudyFile study = parse(kRuns + head + "quantity = \"fps\"\nwithout = [\"map\"]\npaper = 1.94\n" +
                                head + "quantity = \"memory\"\npaper = [1.15, 2.04]\n" + head +
                                "quantity = \"pass_time\"\npass = \"map\"\nat_least = 1\n" + head +
                                "quantity = \"time\"\n[claim.paper]\n\"assets/bunny\" = 0.5\n");
  ASSERT_EQ(study.claims.size(), 4u);
  EXPECT_EQ(study.claims[0].quantity, Quantity::fps);
  EXPECT_THAT(study.claims[0].without, ElementsAre("map"));
  EXPECT_EQ(paper_ratio(study.claims[0], "plate")->low, 1.94);
  EXPECT_FALSE(study.claims[0].every_scene->is_range());
  EXPECT_TRUE(study.claims[1].every_scene->is_range());
  EXPECT_EQ(study.claims[2].pass, "map");
  EXPECT_TRUE(std::isinf(study.claims[2].every_scene->high));
  EXPECT_FALSE(paper_ratio(study.claims[3], "plate"));
  EXPECT_EQ(paper_ratio(study.claims[3], "assets/bunny")->high, 0.5);
}

struct BadStudy {
  const char* name;
  std::string body;
  std::string message;
};

std::string bad_claim(const std::string& rest) {
  return std::string(kRuns) + "[[claim]]\ntext = \"t\"\nsource = \"A\"\n" + rest;
}

const std::string kSides = "numerator = \"a\"\ndenominator = \"b\"\n";

class BadStudyFile : public testing::TestWithParam<BadStudy> {};

TEST_P(BadStudyFile, IsRejectedAtItsPlaceWithAReason) {
  try {
    parse(GetParam().body);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
    EXPECT_THAT(error.what(), testing::StartsWith("study.toml:"));
  }
}

const std::vector<BadStudy> kBadStudies{
    {"UnknownKey", std::string("framse = 3\n") + kRuns, "'frames'"},
    {"NoRuns", "", "no [[run]]"},
    {"NoFrames", std::string("frames = 0\n") + kRuns, "'frames' is 0, not in 1 to 10000"},
    {"NoWidth", std::string("width_px = 0\n") + kRuns, "'width_px' is 0, not 1 or more"},
    {"NoBudget", std::string("frame_budget_s = 0.0\n") + kRuns, "'frame_budget_s' is 0, not positive"},
    {"SeedTwice", std::string("seeds = [1, 1]\n") + kRuns, "seed 1 is given twice"},
    {"SeedOfText", std::string("seeds = [\"a\"]\n") + kRuns, "not a whole number"},
    {"NoSeeds", std::string("seeds = []\n") + kRuns, "no list of whole numbers"},
    {"LabelTwice", std::string(kRuns) + kRuns, "two runs are labelled 'a'"},
    {"NoTechnique", "[[run]]\nlabel = \"a\"\n", "technique"},
    {"UnknownRunKey", "[[run]]\ntechnique = \"a\"\nvalue = 1\n", "'values'"},
    {"EmptyList", run_with("taps = []"), "the list of 'taps' is empty"},
    {"ListOfLists", run_with("taps = [[1]]"), "a value of 'taps' is an array"},
    {"TableOfNothing", run_with("taps = { from = 1 }"), "{ range = [from, to, step] }"},
    {"BothTables", run_with("taps = { range = [1, 2, 1], log = [1, 2, 2] }"), "{ range = [from, to, step] }"},
    {"EmptyRange", run_with("taps = { range = [5, 3, 1] }"), "a range from 5 to 3 by 1 has no values"},
    {"StepOfNothing", run_with("taps = { range = [1, 3, 0] }"), "has no values"},
    {"HugeRange", run_with("taps = { range = [0.0, 1.0, 1e-9] }"), "is longer than 4096"},
    {"ShortRange", run_with("taps = { range = [1, 3] }"), "'range' is not three numbers"},
    {"LogFromZero", run_with("taps = { log = [0, 8, 3] }"), "no logarithmic steps"},
    {"HalfALog", run_with("taps = { log = [1, 8, 2.5] }"), "no logarithmic steps"},
    {"HugeGrid", run_with("a = { range = [1, 100, 1] }\nb = { range = [1, 100, 1] }"),
     "more than 4096 points"},
    {"UnknownPlaceholder", run_with("taps = 3", "{tap}"), "did you mean 'taps'?"},
    {"OpenPlaceholder", run_with("taps = 3", "{taps"), "has no '}'"},
    {"UnknownRunOfAClaim", bad_claim("numerator = \"c\"\n"), "no run is labelled 'c'"},
    {"SameRuns", bad_claim("numerator = \"a\"\ndenominator = \"a\"\n"), "are the same run"},
    {"UnknownQuantity", bad_claim(kSides + "quantity = \"fpss\"\npaper = 2"), "did you mean 'fps'?"},
    {"NoNumber", bad_claim(kSides + "quantity = \"fps\"\n"), "either 'paper' or 'at_least'"},
    {"TwoNumbers", bad_claim(kSides + "quantity = \"fps\"\npaper = 2\nat_least = 1\n"),
     "either 'paper' or 'at_least'"},
    {"RatioOfOne", bad_claim(kSides + "quantity = \"fps\"\npaper = 1\n"), "says nothing about an order"},
    {"NegativeRatio", bad_claim(kSides + "quantity = \"fps\"\npaper = -2\n"), "no positive number"},
    {"EmptyRatioRange", bad_claim(kSides + "quantity = \"fps\"\npaper = [2, 1]\n"),
     "range from 2 to 1 is empty"},
    {"UnknownScene", bad_claim(kSides + "quantity = \"fps\"\npaper = { plat = 2 }\n"),
     "did you mean 'plate'?"},
    {"NoPass", bad_claim(kSides + "quantity = \"pass_time\"\npaper = 2\n"), "pass"},
    {"PassOfAFrame", bad_claim(kSides + "quantity = \"time\"\npass = \"map\"\npaper = 2\n"),
     "'pass' belongs to"},
    {"CostOfMemory", bad_claim(kSides + "quantity = \"memory\"\nunequal_cost = true\npaper = 2\n"),
     "'unequal_cost' is about times"},
    {"MemoryWithoutAPass", bad_claim(kSides + "quantity = \"memory\"\nwithout = [\"map\"]\npaper = 2\n"),
     "'without' belongs to"},
};

INSTANTIATE_TEST_SUITE_P(Each, BadStudyFile, testing::ValuesIn(kBadStudies),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(StudyFileTest, TheExampleInTheDocsAndEveryStudyOfOursAreRead) {
  const std::filesystem::path root = source_dir();
  const std::string page = read_file(root / "docs/studies.md");
  const std::string fence = "```toml\n";
  const size_t start = page.find(fence) + fence.size();
  const StudyFile example = parse_study(page.substr(start, page.find("```", start) - start), "studies.md");
  EXPECT_THAT(labels(example), ElementsAre("PCF 3 x 3", "PCF 7 x 7"));
  int studies = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(root / "studies")) {
    if (file.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(load_study(file.path())) << file.path();
    ++studies;
  }
  EXPECT_GE(studies, 5);
}

TEST(StudyFileTest, TheSchemaAndScenesAreChecked) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_study(text, "study.toml");
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string runs = kRuns;
  EXPECT_THAT(message("schema = 2\n" + runs), HasSubstr("schema 2 is not known (this reads 1)"));
  EXPECT_THAT(message("schema = 1\ntitle = \"t\"\nscenes = []\n" + runs), HasSubstr("no scenes"));
  EXPECT_THAT(message("schema = 1\ntitle = \"t\"\nscenes = [\"a\", \"a\"]\n" + runs),
              HasSubstr("'a' is given twice"));
  EXPECT_THAT(message("schema = 1\nscenes = [\"a\"]\n" + runs), HasSubstr("title"));
}

}  // namespace
}  // namespace umbrameter
