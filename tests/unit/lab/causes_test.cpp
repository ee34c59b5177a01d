// SPDX-License-Identifier: Apache-2.0
// Without these tests a fault's cause could be named by a substitution that changes two things, changes nothing, or mends
// nothing.
#include "lab/causes/blocker_extension.h"
#include "lab/causes/causes_wanted.h"
#include "lab/causes/find_causes.h"
#include "lab/causes/light_parts.h"
#include "results/causes_format.h"
#include "results/json/causes_json.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <set>

namespace umbrameter {
namespace {

Parameter number(const std::string& name, const std::string& group, const std::string& unit, double value,
                 double min, double max, ParameterScale scale = ParameterScale::linear) {
  Parameter parameter;
  parameter.name = name;
  parameter.group = group;
  parameter.unit = unit;
  parameter.default_value = value;
  parameter.min = min;
  parameter.max = max;
  parameter.scale = scale;
  return parameter;
}

Parameter count(const std::string& name, const std::string& group, const std::string& unit, int64_t value,
                double max, ParameterScale scale) {
  Parameter parameter = number(name, group, unit, 0.0, 1.0, max, scale);
  parameter.type = ParameterType::integer;
  parameter.default_value = value;
  return parameter;
}

/// Parameters as manifests declare them.
std::vector<Parameter> declared_parameters() {
  Parameter fit;
  fit.name = "map_fit";
  fit.group = "shadow_map";
  fit.type = ParameterType::choice;
  fit.choices = {"none", "scene", "visible"};
  fit.default_value = std::string("visible");
  return {number("bias_texels", "bias", "texels", 0.1, 0.0, 32.0),
          number("slope_bias", "bias", "none", 0.0, 0.0, 16.0),
          number("radius_texels", "filter", "texels", 2.0, 0.0, 64.0),
          count("map_size", "shadow_map", "texels", 2048, 8192.0, ParameterScale::pow2),
          count("filter_taps", "filter", "taps", 16, 1024.0, ParameterScale::log),
          count("grid_taps", "filter", "taps", 3, 32.0, ParameterScale::linear),
          number("light_size_scale", "light", "none", 1.0, 0.1, 10.0, ParameterScale::log),
          fit};
}

const std::vector<Parameter> kDeclared = declared_parameters();

SubstitutedRun run_with(const ParameterValues& values = {}) {
  SubstitutedRun run;
  run.declared = kDeclared;
  run.parameters = default_values(kDeclared);
  for (const auto& [name, value] : values) run.parameters[name] = value;
  run.light.size_world = {2.0, 1.0};
  run.diagonal_world = 10.0;
  run.memory_bytes = 16 << 20;
  return run;
}

std::optional<Replacement> replaced(std::string_view id, const ParameterValues& values = {}) {
  return replace(*find_substitution(id), run_with(values));
}

double real(const Replacement& replacement, const std::string& name) {
  return std::get<double>(replacement.parameters.at(name));
}

int64_t whole(const Replacement& replacement, const std::string& name) {
  return std::get<int64_t>(replacement.parameters.at(name));
}

TEST(Substitutions, HaveTheirOwnNamesAndMeanings) {
  std::set<std::string_view> ids;
  for (const Substitution& substitution : substitutions()) {
    EXPECT_TRUE(ids.insert(substitution.id).second) << substitution.id;
    EXPECT_FALSE(substitution.label.empty());
    EXPECT_FALSE(substitution.meaning.empty());
    EXPECT_GE(substitution.draws, 1.0);
    EXPECT_EQ(find_substitution(substitution.id), &substitution);
  }
  EXPECT_EQ(find_substitution("magic"), nullptr);
}

TEST(Substitutions, BiasGoesToNoneAndTenTimesItself) {
  const auto none = replaced("bias_zero", {{"bias_texels", 4.0}});
  EXPECT_EQ(real(*none, "bias_texels"), 0.0);
  EXPECT_THAT(none->changes, testing::ElementsAre("bias_texels 4 -> 0"));
  const auto tenfold = replaced("bias_tenfold", {{"bias_texels", 4.0}});
  EXPECT_EQ(real(*tenfold, "bias_texels"), 32.0);
  EXPECT_THAT(tenfold->changes, testing::ElementsAre("bias_texels 4 -> 32 (its largest)"));
}

TEST(Substitutions, ATenthOfTheBiasIsWithoutTheAcneOfNone) {
  EXPECT_DOUBLE_EQ(real(*replaced("bias_tenth", {{"bias_texels", 32.0}}), "bias_texels"), 3.2);
  EXPECT_FALSE(replaced("bias_tenth", {{"bias_texels", 0.0}}));
}

TEST(Substitutions, ASmallMapGrowsSixteenfoldAndALargeOneOnlyOnce) {
  SubstitutedRun small = run_with({{"map_size", int64_t{128}}});
  small.memory_bytes = 64 << 10;
  const auto larger = replace(*find_substitution("map_sixteenfold"), small);
  EXPECT_EQ(whole(*larger, "map_size"), 2048);
  EXPECT_DOUBLE_EQ(real(*larger, "radius_texels"), 32.0);
  EXPECT_EQ(whole(*replaced("map_sixteenfold", {{"map_size", int64_t{1024}}}), "map_size"), 8192);
  // As large as the fourfold map is.
  EXPECT_FALSE(replaced("map_sixteenfold", {{"map_size", int64_t{2048}}}));
}

TEST(Substitutions, NoBiasGrowsFromTheDefault) {
  const auto tenfold = replaced("bias_tenfold", {{"bias_texels", 0.0}});
  EXPECT_DOUBLE_EQ(real(*tenfold, "bias_texels"), 1.0);
  EXPECT_EQ(real(*tenfold, "slope_bias"), 0.0);
  EXPECT_FALSE(replaced("bias_zero", {{"bias_texels", 0.0}}));
}

TEST(Substitutions, ALargerMapKeepsLengthsInTheWorld) {
  const auto larger = replaced("map_fourfold", {{"map_size", int64_t{512}}});
  EXPECT_EQ(whole(*larger, "map_size"), 2048);
  EXPECT_DOUBLE_EQ(real(*larger, "radius_texels"), 8.0);
  EXPECT_DOUBLE_EQ(real(*larger, "bias_texels"), 0.4);
  EXPECT_EQ(real(*larger, "slope_bias"), 0.0);
}

TEST(Substitutions, AMapGrowsAsFarAsItsRangeAndTheMemoryAllow) {
  EXPECT_EQ(whole(*replaced("map_fourfold", {{"map_size", int64_t{4096}}}), "map_size"), 8192);
  EXPECT_FALSE(replaced("map_fourfold", {{"map_size", int64_t{8192}}}));
  EXPECT_EQ(whole(*replaced("map_fourfold", {{"radius_texels", 20.0}}), "map_size"), 4096);
  EXPECT_FALSE(replaced("map_fourfold", {{"bias_texels", 20.0}}));
  SubstitutedRun heavy = run_with();
  heavy.memory_bytes = uint64_t{300} << 20;
  EXPECT_EQ(whole(*replace(*find_substitution("map_fourfold"), heavy), "map_size"), 4096);
  heavy.memory_bytes = uint64_t{900} << 20;
  EXPECT_FALSE(replace(*find_substitution("map_fourfold"), heavy));
}

TEST(Substitutions, TapsAreCountsAndNotSidesOfAGrid) {
  const auto more = replaced("taps_fourfold");
  EXPECT_EQ(whole(*more, "filter_taps"), 64);
  EXPECT_EQ(whole(*more, "grid_taps"), 3);
  EXPECT_EQ(whole(*more, "map_size"), 2048);
}

TEST(Substitutions, FiltersFollowTheirWidthAndTheLight) {
  const auto narrow = replaced("filter_quarter");
  EXPECT_DOUBLE_EQ(real(*narrow, "radius_texels"), 0.5);
  EXPECT_DOUBLE_EQ(real(*narrow, "light_size_scale"), 0.25);
  EXPECT_DOUBLE_EQ(real(*narrow, "bias_texels"), 0.1);
  const auto wide = replaced("filter_fourfold", {{"radius_texels", 0.0}});
  EXPECT_DOUBLE_EQ(real(*wide, "radius_texels"), 8.0);
}

TEST(Substitutions, AMapOfTheSceneIsAChoiceOfThatName) {
  EXPECT_EQ(to_text(replaced("fit_scene")->parameters.at("map_fit")), "scene");
  EXPECT_FALSE(replaced("fit_scene", {{"map_fit", std::string("scene")}}));
}

TEST(Substitutions, LengthsOfTheSceneStayInItsRange) {
  std::vector<Parameter> declared = {number("bias_world", "bias", "world", 0.0, 0.0, 0.5)};
  declared.front().is_relative_to_scene = true;
  SubstitutedRun run;
  run.declared = declared;
  run.parameters = {{"bias_world", 1.0}};
  run.diagonal_world = 10.0;
  const auto tenfold = replace(*find_substitution("bias_tenfold"), run);
  EXPECT_DOUBLE_EQ(real(*tenfold, "bias_world"), 5.0);
}

TEST(Substitutions, OnlyWhatLooksForBlockersTakesTheTruths) {
  EXPECT_FALSE(replaced("blocker_truth"));
  std::vector<Parameter> declared = kDeclared;
  declared.push_back(count("search_taps", "search", "taps", 16, 1024.0, ParameterScale::log));
  SubstitutedRun run = run_with({{"search_taps", int64_t{16}}});
  run.declared = declared;
  EXPECT_TRUE(replace(*find_substitution("blocker_truth"), run)->takes_blocker_truth);
}

TEST(LightParts, TileARectangle) {
  Light light;
  light.center_world = {1, 2, 3};
  light.size_world = {2.0, 1.0};
  const std::vector<Light> parts = light_parts(light);
  ASSERT_EQ(parts.size(), 16u);
  glm::dvec3 middle(0.0);
  for (const Light& part : parts) {
    EXPECT_EQ(part.size_world, glm::dvec2(0.5, 0.25));
    middle += part.center_world / 16.0;
  }
  EXPECT_NEAR(glm::distance(middle, light.center_world), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(parts.front().center_world, glm::dvec3(0.25, 2.0, 2.625)), 0.0, 1e-12);
}

TEST(LightParts, StayOnARoundLight) {
  for (const LightType type : {LightType::disk, LightType::sphere}) {
    Light light;
    light.type = type;
    light.radius_world = 2.0;
    for (const Light& part : light_parts(light)) {
      EXPECT_DOUBLE_EQ(part.radius_world, 0.5);
      EXPECT_LE(glm::length(part.center_world), 2.0);
    }
  }
}

TEST(LightParts, OfTheSunFaceOtherWays) {
  Light sun;
  sun.type = LightType::sun;
  sun.half_angle_rad = 0.1;
  glm::dvec3 mean(0.0);
  for (const Light& part : light_parts(sun)) {
    EXPECT_DOUBLE_EQ(part.half_angle_rad, 0.025);
    EXPECT_LE(std::acos(glm::dot(part.direction_world, sun.direction_world)), 0.1);
    const glm::dvec3 cross = glm::cross(part.tangent_world, part.bitangent_world);
    EXPECT_NEAR(glm::distance(cross, part.direction_world), 0.0, 1e-12);
    mean += part.direction_world / 16.0;
  }
  EXPECT_LT(std::acos(glm::dot(glm::normalize(mean), sun.direction_world)), 0.02);
}

Image picture_of(const std::vector<float>& visibility) {
  Image image(static_cast<int>(visibility.size()), 1);
  std::ranges::copy(visibility, image.add_plane("visibility").begin());
  return image;
}

const std::vector<FaultClass> kClasses = {FaultClass::acne, FaultClass::acne, FaultClass::peter_panning,
                                          FaultClass::explained, FaultClass::unscored};
const std::vector<FaultClass> kFaults = {FaultClass::peter_panning, FaultClass::acne};
const Image kTruth = picture_of({1.0f, 1.0f, 0.0f, 0.5f, 0.0f});
const Image kWrong = picture_of({0.8f, 0.8f, 0.8f, 0.6f, 1.0f});

TEST(FaultCauses, AFaultIsMeasuredInItsOwnPixels) {
  const auto faults = caused_faults(kClasses, kWrong, kTruth, kFaults);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].pixels, 1u);
  EXPECT_NEAR(faults[0].mean_abs_error, 0.8 / 4.0, 1e-6);  // four pixels are scored
  EXPECT_EQ(faults[1].pixels, 2u);
  EXPECT_NEAR(faults[1].mean_abs_error, 0.4 / 4.0, 1e-6);
}

TEST(FaultCauses, WhatIsRemovedIsASignedShare) {
  const auto faults = caused_faults(kClasses, kWrong, kTruth, kFaults);
  SubstitutionOutcome outcome;
  const Image changed = picture_of({0.6f, 0.8f, 0.2f, 0.9f, 0.0f});
  measure_substitution(changed, kWrong, kTruth, kClasses, faults, outcome);
  EXPECT_NEAR(outcome.removed[0], 0.75, 1e-6);    // .8 -> .2
  EXPECT_NEAR(outcome.removed[1], -0.5, 1e-6);    // .4 -> .6
  EXPECT_NEAR(outcome.elsewhere, 0.3 / 4, 1e-6);  // .1 -> .4; the unscored pixel does not count
}

TEST(FaultCauses, AnotherSizeIsRefused) {
  EXPECT_THROW(caused_faults(kClasses, picture_of({1.0f}), kTruth, kFaults), Error);
}

FaultCauses causes_with(std::vector<SubstitutionOutcome> outcomes,
                        FaultClass fault = FaultClass::peter_panning) {
  FaultCauses causes;
  causes.faults = {{fault, 20, 0.028}};
  causes.outcomes = std::move(outcomes);
  return causes;
}

TEST(FaultCauses, TheBestIsTheOneThatHarmsLeastAmongThoseAlike) {
  const FaultCauses causes = causes_with({{"bias_zero", {}, {}, {0.93}, 0.2},
                                          {"map_fourfold", {}, {}, {0.90}, 0.0},
                                          {"taps_fourfold", {}, {}, {0.80}, -0.1},
                                          {"blocker_truth", {}, "not there", {}, 0.0}});
  EXPECT_EQ(best_substitution(causes, 0)->id, "map_fourfold");
  EXPECT_EQ(cause_of(causes, 0)->id, "map_fourfold");
}

TEST(FaultCauses, WhatReplacesMuchStandsBackWhereOneThingMends) {
  const auto with_taps = [](double removed) {
    return causes_with({{"taps_fourfold", {}, {}, {removed}, 0.0}, {"light_points", {}, {}, {0.9}, -0.1}});
  };
  EXPECT_EQ(cause_of(with_taps(0.6), 0)->id, "taps_fourfold");
  EXPECT_EQ(cause_of(with_taps(0.4), 0)->id, "light_points");
}

TEST(FaultCauses, AWidthThatFollowsFromTheBlockersIsNotToBlame) {
  const auto with_truth = [](double removed) {
    return causes_with({{"filter_half", {}, {}, {0.95}, -0.1}, {"blocker_truth", {}, {}, {removed}, 0.01}});
  };
  EXPECT_EQ(cause_of(with_truth(0.92), 0)->id, "blocker_truth");
  EXPECT_EQ(cause_of(with_truth(0.80), 0)->id, "filter_half");
}

TEST(FaultCauses, WhatBreaksMoreThanItMendsStandsBack) {
  const auto with_tenth = [](double removed) {
    return causes_with({{"bias_zero", {}, {}, {0.99}, 0.2}, {"bias_tenth", {}, {}, {removed}, 0.0}});
  };
  EXPECT_EQ(cause_of(with_tenth(0.6), 0)->id, "bias_tenth");
  EXPECT_EQ(cause_of(with_tenth(0.4), 0)->id, "bias_zero");  // of .028 it adds .2, but nothing else mends
}

TEST(FaultCauses, ADistanceThatFollowsFromTheMapIsNotToBlame) {
  const auto with_map = [](double removed) {
    return causes_with({{"filter_half", {}, {}, {0.95}, -0.1},
                        {"map_sixteenfold", {}, {}, {removed}, 0.01},
                        {"blocker_truth", {}, {}, {0.94}, 0.0}});
  };
  EXPECT_EQ(cause_of(with_map(0.92), 0)->id, "map_sixteenfold");
  EXPECT_EQ(cause_of(with_map(0.80), 0)->id, "blocker_truth");
}

TEST(BlockerExtension, SaysHowFarBlockersAreAndNotWhetherThereAreAny) {
  Image truth(5, 1);
  std::ranges::copy(std::vector<float>{0.0f, 1.0f, 0.0f, 0.0f, 0.0f},
                    truth.add_plane("blocker_offset.x").begin());
  std::ranges::copy(std::vector<float>{0.0f, 0.0f, 0.0f, 0.0f, 2.0f},
                    truth.add_plane("blocker_offset.y").begin());
  truth.add_plane("blocker_offset.z");
  const Image extended = extended_blockers(truth);
  EXPECT_THAT(extended.plane("blocker_offset.x"), testing::ElementsAre(1.0f, 1.0f, 1.0f, 0.0f, 0.0f));
  EXPECT_THAT(extended.plane("blocker_offset.y"), testing::ElementsAre(0.0f, 0.0f, 0.0f, 2.0f, 2.0f));
  EXPECT_THAT(extended.plane("blocker_offset.z"), testing::Each(0.0f));
  truth.planes["blocker_offset.x"].assign(5, 0.0f);
  truth.planes["blocker_offset.y"].assign(5, 0.0f);
  EXPECT_THAT(extended_blockers(truth).plane("blocker_offset.x"), testing::Each(0.0f));
}

TEST(FaultCauses, WhatMendsTooLittleIsNoCause) {
  const FaultCauses causes =
      causes_with({{"bias_zero", {}, {}, {0.12}, 0.0}, {"map_fourfold", {}, {}, {-2.0}, 0.0}});
  EXPECT_EQ(best_substitution(causes, 0)->id, "bias_zero");
  EXPECT_EQ(cause_of(causes, 0), nullptr);
  EXPECT_EQ(best_substitution(causes_with({}), 0), nullptr);
}

TEST(CauseSentences, SayWhatMendsAndWhatDoesNot) {
  const auto of = [](const FaultCauses& causes) { return cause_sentences(causes).front(); };
  EXPECT_EQ(of(causes_with({{"bias_zero", {}, {}, {0.01}, 0.0},
                            {"bias_tenfold", {}, {}, {-1.0}, 0.0},
                            {"blocker_truth", {}, {}, {0.91}, 0.0}})),
            "peter panning 0.02800: no bias mends it; the truth's blocker distance removes 91 %: the search "
            "does not find "
            "the blockers' true distance");
  EXPECT_EQ(of(causes_with({{"bias_zero", {}, {}, {0.01}, 0.0},
                            {"blocker_truth", {}, {}, {0.91}, 0.0},
                            {"light_points", {}, {}, {0.85}, 0.3}})),
            "peter panning 0.02800: no bias mends it; the truth's blocker distance removes 91 %: the search "
            "does not "
            "find these blockers in one map from the light's centre");
  EXPECT_EQ(of(causes_with({{"bias_zero", {}, {}, {0.97}, 0.01}})),
            "peter panning 0.02800: bias 0 removes 97 % (and adds 0.01000 elsewhere): the bias is too large");
  EXPECT_EQ(of(causes_with({{"bias_zero", {}, {}, {0.2}, 0.0}})),
            "peter panning 0.02800: nothing that was tried mends it; most does bias 0: 20 %");
  EXPECT_EQ(of(causes_with({{"bias_zero", {}, {}, {-0.2}, 0.0}})),
            "peter panning 0.02800: nothing that was tried mends it");
  EXPECT_EQ(of(causes_with({})), "peter panning 0.02800: nothing could be tried");
}

TEST(CauseTable, SaysWorseWhereItIs) {
  const auto rows = cause_table(causes_with({{"bias_zero", {"bias_texels 4 -> 0"}, {}, {-1.5}, 0.0}}));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0], testing::ElementsAre("instead", "peter panning", "elsewhere", "changed"));
  EXPECT_THAT(rows[1], testing::ElementsAre("bias 0", "worse x 2.5", "+0.00000", "bias_texels 4 -> 0"));
}

TEST(FindCauses, TriesWhatTheRunHasAndNotesWhatFails) {
  const auto draw = [](const Replacement& replacement, const Light& light) {
    if (std::get<int64_t>(replacement.parameters.at("map_size")) > 2048) fail_input("no room for the map");
    if (real(replacement, "bias_texels") == 0.0) return kTruth;
    return light.size_world.x < 2.0 ? picture_of({1.0f, 1.0f, 0.4f, 0.5f, 0.0f}) : kWrong;
  };
  const FaultCauses causes = find_causes(run_with(), {kWrong, kTruth, kClasses}, kFaults, draw);
  std::vector<std::string> ids;
  for (const SubstitutionOutcome& outcome : causes.outcomes) ids.push_back(outcome.id);
  EXPECT_THAT(ids, testing::ElementsAre("bias_zero", "bias_tenth", "bias_tenfold", "filter_quarter",
                                        "filter_half", "filter_double", "filter_fourfold", "taps_fourfold",
                                        "map_fourfold", "fit_scene", "light_points"));
  EXPECT_THAT(cause_of(causes, 0)->id, "bias_zero");
  EXPECT_NEAR(causes.outcomes.front().removed[0], 1.0, 1e-6);
  EXPECT_EQ(causes.outcomes[2].removed[0], 0.0);
  EXPECT_EQ(causes.outcomes[8].not_tried, "no room for the map");
  EXPECT_NEAR(causes.outcomes[10].removed[0], 0.5, 1e-6);
  EXPECT_EQ(draws_of_causes(run_with()), 41.0);  // 16 of the light, 8 of maps, 8 of filters, 4 of taps, 3, 2
}

TEST(FindCauses, KeepsLengthsInTheWorldWhereAnotherFitMovesTexels) {
  std::vector<double> radii;
  const auto draw = [&](const Replacement& replacement, const Light&) {
    const bool is_whole = to_text(replacement.parameters.at("map_fit")) == "scene";
    if (is_whole) radii.push_back(real(replacement, "radius_texels"));
    Image image = kWrong;
    image.add_plane("texel_world", is_whole ? 1.0f : 0.25f);
    return image;
  };
  Image wrong = kWrong;
  wrong.add_plane("texel_world", 0.25f);
  const FaultCauses causes =
      find_causes(run_with({{"radius_texels", 8.0}}), {wrong, kTruth, kClasses}, kFaults, draw);
  EXPECT_THAT(radii, testing::ElementsAre(8.0, 2.0));  // texels are four times as large
  const auto fit = std::ranges::find(causes.outcomes, "fit_scene", &SubstitutionOutcome::id);
  ASSERT_NE(fit, causes.outcomes.end());
  EXPECT_THAT(fit->changes, testing::Contains("radius_texels 8 -> 2"));
}

TEST(FaultCauses, ComeBackFromJson) {
  FaultCauses causes = causes_with(
      {{"bias_zero", {"bias_texels 4 -> 0"}, {}, {0.97}, -0.01}, {"map_fourfold", {}, "no", {}, 0.0}});
  const auto read = read_fault_causes(fault_causes_json(causes));
  ASSERT_TRUE(read);
  EXPECT_EQ(fault_causes_json(read), fault_causes_json(causes));
  EXPECT_EQ(read->outcomes[1].not_tried, "no");
  EXPECT_EQ(fault_causes_json(causes).at("faults").at(0).at("cause"), "bias_zero");
  EXPECT_FALSE(read_fault_causes(nlohmann::json()));
}

TEST(CausesWanted, IsChosenByName) {
  EXPECT_EQ(choose_causes("auto"), CausesWanted::automatic);
  EXPECT_EQ(choose_causes("all"), CausesWanted::all);
  EXPECT_THROW(choose_causes("some"), Error);
}

}  // namespace
}  // namespace umbrameter
