// SPDX-License-Identifier: Apache-2.0
// Without these, a run could be called dominated inside the noise, a question be answered with the wrong run, or a
// paper be contradicted by a slip.

#include "study/grid/bench.h"

#include "core/error.h"
#include "results/bench/bench_json.h"
#include "results/json/run_json.h"
#include "results/json/schemas.h"
#include "tests/support/lab/fakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::json;

BenchEntry entry(const std::string& label, Interval time_ms, Interval rmse) {
  BenchEntry result;
  result.label = label;
  result.time_ms = time_ms;
  result.error.emplace().rmse = rmse;
  return result;
}

TEST(Front, OnlyBothIntervalsTogetherDominate) {
  std::vector<BenchEntry> entries{
      entry("fast", {1, 0.9, 1.1}, {0.10, 0.09, 0.11}),
      entry("good", {4, 3.9, 4.1}, {0.01, 0.008, 0.012}),
      entry("worse", {2, 1.9, 2.1}, {0.20, 0.19, 0.21}),       // slower and further off than "fast"
      entry("as good", {2, 1.9, 2.1}, {0.105, 0.10, 0.11}),    // RMSE within the noise of "fast"
      entry("as fast", {1.05, 0.95, 1.2}, {0.2, 0.19, 0.21}),  // time within the noise of "fast"
      entry("bad", {9, 8, 10}, {0.3, 0.29, 0.31}),             // dominated by all; the fastest is named
  };
  entries.push_back(entry("untold", {1, 1, 1}, {0.5, 0.5, 0.5}));
  entries.back().time_ms.reset();
  find_front(entries);
  std::vector<std::string> dominated_by;
  for (const BenchEntry& each : entries) dominated_by.push_back(each.dominated_by.value_or(""));
  EXPECT_THAT(dominated_by, ElementsAre("", "", "fast", "", "", "fast", ""));
  EXPECT_TRUE(entries[0].has_place);
  EXPECT_FALSE(entries[6].has_place);
}

TEST(Queries, NeedTheWholeIntervalAndNameTies) {
  std::vector<BenchEntry> entries{
      entry("a", {1, 0.9, 1.1}, {0.10, 0.09, 0.11}),
      entry("b", {2, 1.9, 2.1}, {0.05, 0.04, 0.06}),
      entry("c", {2.5, 2.4, 2.6}, {0.055, 0.045, 0.065}),
      entry("d", {3, 2.9, 3.2}, {0.01, 0.009, 0.011}),
  };
  find_front(entries);
  EXPECT_THAT(best_under(entries, 3.1), ElementsAre(1, 2));  // "d" may take 3.2
  EXPECT_THAT(best_under(entries, 3.3), ElementsAre(3));
  EXPECT_THAT(best_under(entries, 0.5), IsEmpty());
  EXPECT_THAT(cheapest_below_rmse(entries, 0.062), ElementsAre(1));
  EXPECT_THAT(cheapest_below_rmse(entries, 0.2), ElementsAre(0));
  EXPECT_THAT(cheapest_below_rmse(entries, 0.01), IsEmpty());
  EXPECT_THAT(best_under(std::vector<BenchEntry>{}, 1.0), IsEmpty());
}

/// Frames of a map of 1 ms and a filter from `low` to `high` ms.
BenchEntry timed(const std::string& label, double low, double high, int frames = 30) {
  BenchEntry result;
  result.label = label;
  result.times.passes = {"map", "filter"};
  for (int i = 0; i < frames; ++i)
    result.times.frames_ms.push_back({1.0, low + (high - low) * i / std::max(1, frames - 1)});
  result.memory_bytes = label == "slow" ? 3000 : 1000;
  return result;
}

StudyScene study_scene(const std::string& name) {
  return {name, fake_scene(name).scene};
}

class Claims : public testing::Test {
 protected:
  ClaimResult judge(Quantity quantity, PaperRatio paper, const std::string& pass = {},
                    const std::vector<std::string>& without = {}) const {
    Claim claim;
    claim.numerator = "slow";
    claim.denominator = "fast";
    claim.quantity = quantity;
    claim.pass = pass;
    claim.without = without;
    claim.every_scene = paper;
    return judge_claims(std::array{claim}, "plate", entries_).at(0);
  }
  std::vector<BenchEntry> entries_{timed("fast", 1.0, 1.0), timed("slow", 3.0, 3.0)};
};

TEST_F(Claims, RatiosOfFramesPassesAndMemory) {
  EXPECT_DOUBLE_EQ(judge(Quantity::time, {1.5, 1.5}).ours->value, 2.0);  // 1 + 3 against 1 + 1
  EXPECT_DOUBLE_EQ(judge(Quantity::fps, {1.5, 1.5}).ours->value, 0.5);
  EXPECT_DOUBLE_EQ(judge(Quantity::time, {1.5, 1.5}, {}, {"map"}).ours->value, 3.0);
  EXPECT_DOUBLE_EQ(judge(Quantity::pass_time, {1.5, 1.5}, "filter").ours->value, 3.0);
  EXPECT_DOUBLE_EQ(judge(Quantity::memory, {1.5, 1.5}).ours->value, 3.0);
}

TEST_F(Claims, ANumberIsAnOrderAndARangeARange) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(verdict_text(judge(Quantity::time, {1.1, 1.1})), "same order");
  EXPECT_EQ(verdict_text(judge(Quantity::time, {0.9, 0.9})), "opposite order");
  EXPECT_EQ(verdict_text(judge(Quantity::fps, {0.9, 0.9})), "same order");
  EXPECT_EQ(verdict_text(judge(Quantity::time, {1.9, 2.1})), "inside");
  EXPECT_EQ(verdict_text(judge(Quantity::time, {2.1, 2.2})), "outside");
  EXPECT_EQ(verdict_text(judge(Quantity::time, {1.0, infinity})), "holds");
  EXPECT_EQ(verdict_text(judge(Quantity::fps, {1.0, infinity})), "fails");
  EXPECT_EQ(format_paper({1.0, infinity}), "at least 1");
  EXPECT_EQ(format_paper({1.15, 2.04}), "1.15 to 2.04");
}

TEST_F(Claims, NoVerdictInsideTheNoise) {
  entries_ = {timed("fast", 1.0, 3.0), timed("slow", 1.2, 3.2)};
  const ClaimResult result = judge(Quantity::time, {1.5, 1.5});
  EXPECT_EQ(result.verdict, Verdict::cannot_tell);
  EXPECT_EQ(result.reason, "the interval holds both answers");
  EXPECT_LT(result.ours->low, 1.0);
  EXPECT_GT(result.ours->high, 1.0);
}

TEST_F(Claims, NoVerdictOnTimesOfOnePictureUnlessThatIsTheClaim) {
  entries_[0].picture_hash = entries_[1].picture_hash = "a";
  EXPECT_EQ(judge(Quantity::time, {1.5, 1.5}).reason, "both runs drew the same picture, to the bit");
  EXPECT_FALSE(judge(Quantity::fps, {1.5, 1.5}).ours);
  EXPECT_TRUE(judge(Quantity::memory, {1.5, 1.5}).reason.empty());
  Claim claim;
  claim.numerator = "slow";
  claim.denominator = "fast";
  claim.every_scene = PaperRatio{1.5, 1.5};
  claim.pictures = ClaimPictures::same;
  EXPECT_EQ(judge_claims(std::array{claim}, "plate", entries_).at(0).verdict, Verdict::agrees);
  entries_[1].picture_hash = "b";
  EXPECT_EQ(judge_claims(std::array{claim}, "plate", entries_).at(0).reason, "the two pictures differ");
  claim.pictures = ClaimPictures::either;
  EXPECT_EQ(judge_claims(std::array{claim}, "plate", entries_).at(0).verdict, Verdict::agrees);
  EXPECT_EQ(judge(Quantity::time, {1.5, 1.5}).verdict, Verdict::agrees);
}

TEST_F(Claims, ShowHowOftenBothSidesCompare) {
  EXPECT_EQ(format_compares(judge(Quantity::time, {1.5, 1.5})), "? : ?");
  entries_[0].compares_per_pixel = 16;
  entries_[1].compares_per_pixel = 49;
  EXPECT_EQ(format_compares(judge(Quantity::time, {1.5, 1.5})), "49 : 16");
}

class ClaimCosts : public testing::Test {
 protected:
  /// What is said against a claim that a run of so many comparisons is faster than another; empty for nothing.
  std::string objection(std::optional<double> fast, std::optional<double> slow, bool says_unequal = false,
                        Quantity quantity = Quantity::time) const {
    Claim claim;
    claim.text = "the mask pays";
    claim.numerator = "fast";
    claim.denominator = "slow";
    claim.quantity = quantity;
    claim.has_unequal_cost = says_unequal;
    claim.where = {"study.toml", 7, 1};
    const std::array<RunCost, 2> runs{RunCost{"fast", fast}, RunCost{"slow", slow}};
    try {
      require_fair_costs(std::array{claim}, runs);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "";
  }
};

TEST_F(ClaimCosts, AreEqualToATenth) {
  EXPECT_EQ(objection(16, 16), "");
  EXPECT_EQ(objection(121, 128), "");
  EXPECT_EQ(objection(110, 100), "");
  EXPECT_THAT(objection(111, 100), HasSubstr("compares unequal costs"));
  EXPECT_THAT(objection(25, 16), AllOf(HasSubstr("study.toml:7"), HasSubstr("'the mask pays'"),
                                       HasSubstr("'fast' 25 and 'slow' 16 comparisons per pixel"),
                                       HasSubstr("unequal_cost = true")));
}

TEST_F(ClaimCosts, ThatAreNotKnownAreNotEqual) {
  EXPECT_THAT(objection({}, 16), HasSubstr("'fast' an unknown number and 'slow' 16 comparisons"));
  EXPECT_THAT(objection({}, {}), HasSubstr("'slow' an unknown number"));
  EXPECT_EQ(objection({}, 16, true), "");
}

TEST_F(ClaimCosts, SaidToBeUnequalMustBe) {
  EXPECT_EQ(objection(16, 49, true), "");
  EXPECT_THAT(objection(16, 17, true),
              HasSubstr("says unequal_cost, of 'fast' 16 and 'slow' 17 comparisons per pixel"));
}

TEST_F(ClaimCosts, AreNothingToMemory) {
  EXPECT_EQ(objection(1, 100, false, Quantity::memory), "");
}

TEST_F(Claims, FewFramesFailuresAndUnknownPassesAreSaid) {
  EXPECT_EQ(judge(Quantity::pass_time, {2, 2}, "blur").reason, "'slow' has no pass 'blur'");
  entries_[1] = timed("slow", 3.0, 3.0, 5);
  const ClaimResult few = judge(Quantity::time, {2, 2});
  EXPECT_EQ(few.reason, "fewer than six frames were timed");
  EXPECT_DOUBLE_EQ(few.ours->value, 2.0);
  entries_[1].failure = Failure{ErrorKind::input, "x"};
  EXPECT_EQ(judge(Quantity::time, {2, 2}).reason, "'slow' failed");
  entries_.pop_back();
  EXPECT_EQ(judge(Quantity::time, {2, 2}).reason, "'slow' was skipped");
}

class Bench : public testing::Test {
 protected:
  Bench() : realtime_(fake_realtime()) {
    realtime_.time_frame = [](const RenderRequest& request, int frame) {
      const double ms = request.technique == "exact" ? 4.0 : 1.0;
      return std::vector<double>{ms, 0.001 * frame};
    };
    plan_.picture.width_px = kFakeWidth_px;
    plan_.picture.height_px = kFakeHeight_px;
    plan_.timing = {.wanted_frames = 10, .budget_s = 3.0};
    plan_.picture.seed = 7;
    for (const char* id : {"exact", "off", "broken"}) plan_.runs.push_back({fake_technique(id), 7});
    plan_.runs.push_back({fake_technique("sun-only", {LightType::sun}), 7});
    Claim claim;
    claim.text = "off is faster";
    claim.source = "A, \"table\" 1";
    claim.numerator = "exact";
    claim.denominator = "off";
    claim.every_scene = PaperRatio{3.5, 4.5};
    plan_.claims = {claim};
  }

  BenchResults run() {
    FakeRenderer reference = fake_reference();
    SilentProgress progress;
    const std::vector<StudyScene> scenes{study_scene("plate"), study_scene("assets/bunny")};
    BenchResults results = run_bench(scenes, plan_, {reference, realtime_}, progress);
    EXPECT_EQ(reference.requests.size(), 2u);  // one truth a scene
    EXPECT_EQ(reference.requests[0].seed, 7u);
    return results;
  }

  FakeRenderer realtime_;
  BenchPlan plan_;
};

TEST_F(Bench, MeasuresErrorBesideTime) {
  const BenchResults results = run();
  ASSERT_EQ(results.scenes.size(), 2u);
  const BenchScene& scene = results.scenes[0];
  ASSERT_EQ(scene.entries.size(), 3u);
  const BenchEntry& exact = scene.entries[0];
  const BenchEntry& off = scene.entries[1];
  EXPECT_NEAR(exact.rmse()->value, 0.0, 1e-6);
  // 0.1 over 19 of the 39 scored columns: sqrt(0.01 * 19 / 39).
  EXPECT_NEAR(off.rmse()->value, 0.06980, 1e-4);
  EXPECT_EQ(exact.times.frames_ms.size(), 10u);
  EXPECT_NEAR(exact.time_ms->value, 4.0, 0.1);
  EXPECT_TRUE(exact.has_place && off.has_place);
  EXPECT_FALSE(exact.dominated_by || off.dominated_by);
  EXPECT_THAT(best_under(scene.entries, 2.0), ElementsAre(1));
  EXPECT_THAT(cheapest_below_rmse(scene.entries, 0.02), ElementsAre(0));
  ASSERT_EQ(scene.claims.size(), 1u);
  EXPECT_EQ(verdict_text(scene.claims[0]), "inside");
}

TEST_F(Bench, FailuresAndSkipsAreRecordedAndTheRestGoesOn) {
  const BenchResults results = run();
  ASSERT_TRUE(results.scenes[1].entries[2].failure);
  ASSERT_EQ(all_failures(results).size(), 2u);
  EXPECT_THAT(all_failures(results)[0].message, HasSubstr("plate, broken: broken/resolve.frag:7:3"));
  ASSERT_EQ(results.skipped.size(), 2u);
  EXPECT_EQ(results.skipped[0].reason, "does not support rect lights");
}

TEST_F(Bench, WithoutATruthTimesStandAndErrorsDoNot) {
  FakeRenderer reference([](const RenderRequest&) -> Frame { fail_environment("no memory"); });
  SilentProgress progress;
  const std::vector<StudyScene> scenes{study_scene("plate")};
  const BenchScene scene = run_bench(scenes, plan_, {reference, realtime_}, progress).scenes[0];
  ASSERT_TRUE(scene.failure);
  EXPECT_FALSE(scene.entries[0].rmse());
  EXPECT_FALSE(scene.entries[0].has_place);
  EXPECT_TRUE(scene.entries[0].time_ms);
  EXPECT_EQ(verdict_text(scene.claims[0]), "inside");
}

TEST_F(Bench, AClaimOfASceneHoldsForItsCameras) {
  plan_.claims[0].by_scene = {{"plate", plan_.claims[0].every_scene.value()}};
  plan_.claims[0].every_scene.reset();
  FakeRenderer reference = fake_reference();
  SilentProgress progress;
  std::vector<StudyScene> scenes{study_scene("plate"), study_scene("assets/bunny")};
  scenes[0].camera = "left";
  const BenchResults results = run_bench(scenes, plan_, {reference, realtime_}, progress);
  EXPECT_EQ(results.scenes[0].claims.size(), 1u);
  EXPECT_TRUE(results.scenes[1].claims.empty());
  const Json scene = Json::parse(to_json_text(results, {}))["scenes"][0];
  EXPECT_EQ(scene["name"], "plate, left");
  EXPECT_EQ(scene["scene"], "plate");
  EXPECT_EQ(scene["camera"], "left");
}

TEST_F(Bench, JsonHoldsTheContextAndTheAnswers) {
  const BenchResults results = run();
  const Json json = Json::parse(to_json_text(results, {.best_under_ms = 2.0, .cheapest_below_rmse = 0.02}));
  EXPECT_EQ(json["schema"], kBenchSchema.number);
  EXPECT_EQ(json["note"], "");
  const Json& scene = json["scenes"][1];
  EXPECT_EQ(scene["name"], "assets/bunny");
  EXPECT_EQ(scene["hash"], "0123456789abcdef");
  EXPECT_EQ(scene["best_under"], Json::array({"off"}));
  EXPECT_EQ(scene["cheapest_below_rmse"], Json::array({"exact"}));
  EXPECT_EQ(scene["runs"][0]["seed"], 7);
  EXPECT_EQ(scene["runs"][0]["parameters"]["taps"], 16);
  EXPECT_EQ(scene["runs"][0]["timer"], "fake clock");
  const TechniqueResult read = read_technique(scene["runs"][0]);  // a run has one shape everywhere
  EXPECT_EQ(read.label, "exact");
  EXPECT_EQ(read.error->rmse->value, results.scenes[1].entries[0].rmse()->value);
  EXPECT_EQ(scene["runs"][0]["measurements"]["rmse"], read.error->rmse->value);
  EXPECT_EQ(scene["runs"][0]["pass_times"][2]["pass"], "total");
  EXPECT_EQ(scene["runs"][0]["is_on_front"], true);
  EXPECT_TRUE(scene["runs"][2]["is_on_front"].is_null());
  EXPECT_EQ(scene["claims"][0]["verdict"], "inside");
  EXPECT_EQ(scene["claims"][0]["paper"]["low"], 3.5);
}

TEST_F(Bench, SoftwareRasterisersAreLabelledInEveryOutput) {
  BenchResults results = run();
  EXPECT_THAT(to_csv(results), HasSubstr(",hardware,"));
  results.scenes[0].entries[0].is_software = true;
  EXPECT_THAT(to_json_text(results, {}),
              HasSubstr("\"note\": \"software rasteriser: ratios are not a GPU's\""));
  EXPECT_THAT(to_csv(results), HasSubstr(",software rasteriser: ratios are not a GPU's,"));
}

TEST_F(Bench, CsvHasOneLineARunAndQuotesWhatNeedsIt) {
  plan_.runs[0].technique.label = "exact, \"wide\"";
  plan_.claims.clear();
  const std::string csv = to_csv(run());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 3);
  EXPECT_THAT(csv, testing::StartsWith("scene,scene_hash,label,"));
  EXPECT_THAT(csv, HasSubstr("\nplate,0123456789abcdef,\"exact, \"\"wide\"\"\",exact,"));
}

}  // namespace
}  // namespace umbrameter
