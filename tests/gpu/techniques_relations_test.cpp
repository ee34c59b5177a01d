// SPDX-License-Identifier: Apache-2.0
// What every technique owes whatever its picture: sane values, no self-shadowing, parameters that act.

#include "core/error.h"
#include "realtime/manifest/activity.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace umbrameter {
namespace {

using namespace test;

constexpr int64_t kMapSize = 512, kLightSamples = 8;

/// Values other than the default that should show.
std::vector<ParameterValue> alternatives(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::boolean:
      return {!std::get<bool>(parameter.default_value)};
    case ParameterType::choice: {
      std::vector<ParameterValue> others;
      for (const std::string& choice : parameter.choices) {
        if (ParameterValue(choice) != parameter.default_value) others.emplace_back(choice);
      }
      return others;
    }
    case ParameterType::integer:
      if (parameter.default_value == ParameterValue(static_cast<int64_t>(parameter.min)))
        return {static_cast<int64_t>(std::max(2 * parameter.min, parameter.min + 1))};
      return {static_cast<int64_t>(parameter.min)};
    case ParameterType::real:
      break;
  }
  return {value_of_number(parameter, parameter.min), value_of_number(parameter, parameter.max)};
}

bool holds_constraints(const Technique& technique, const ParameterValues& values) {
  try {
    resolve_parameters(technique, values);
  } catch (const Error&) {
    return false;
  }
  return true;
}

/// A set of values and its picture.
struct Start {
  ParameterValues values;
  std::vector<float> picture;
};

/// Whether a value of `parameter` changes the picture of `start`.
bool acts_on(const Scene& scene, const Technique& technique, const Parameter& parameter, const Start& start) {
  return std::ranges::any_of(alternatives(parameter), [&](const ParameterValue& value) {
    ParameterValues values = start.values;
    values[parameter.name] = value;
    return holds_constraints(technique, values) &&
           largest_difference(start.picture, visibility(scene, technique.id, values)) > 0.0;
  });
}

/// The quick defaults, the same without the bias that alone is enough, with every choice and switch turned in its place,
/// and the presets: some parameters only act beside others.
std::vector<ParameterValues> starting_points(const Technique& technique) {
  const ParameterValues base = quick(technique, kMapSize, kLightSamples);
  std::vector<ParameterValues> points{base};
  const auto has = [&](const char* name) {
    return std::ranges::find(technique.parameters, name, &Parameter::name) != technique.parameters.end();
  };
  if (has("normal_offset_texels")) {
    points.push_back(base);
    points.back()["normal_offset_texels"] = 0.0;
  }
  for (const Parameter& parameter : technique.parameters) {
    if (parameter.type != ParameterType::choice && parameter.type != ParameterType::boolean) continue;
    for (const ParameterValue& value : alternatives(parameter)) {
      ParameterValues values = base;
      values[parameter.name] = value;
      if (holds_constraints(technique, values)) points.push_back(values);
    }
  }
  for (const Preset& preset : technique.presets) {
    points.push_back(base);
    points.back()["preset"] = preset.name;
  }
  return points;
}

/// A rect and a sun stand for all lights; techniques that do not take the one are tried with a sphere.
bool is_tried(const Technique& technique, LightType type) {
  return technique.supports(type) && (type != LightType::sphere || !technique.supports(LightType::rect));
}

class EachTechnique : public testing::TestWithParam<std::string> {};

/// The first of `points` beside which the parameter is said not to act.
std::optional<ParameterValues> without_effect(const Technique& technique, const Parameter& parameter,
                                              const std::vector<ParameterValues>& points,
                                              const Light& light) {
  for (const ParameterValues& values : points) {
    if (!is_active(technique, parameter, resolve_parameters(technique, values), light)) return values;
  }
  return std::nullopt;
}

TEST_P(EachTechnique, parameters_act_only_when_their_manifest_says) {
  UMBRAMETER_REQUIRE_GL();
  const auto all = techniques();
  const Technique& technique = *std::ranges::find(all, GetParam(), &Technique::id);
  const std::vector<ParameterValues> points = starting_points(technique);
  for (const LightType type : {LightType::rect, LightType::sun}) {
    const Scene scene = busy_scene(light_at_4(type, 0.5));
    if (!technique.supports(type)) continue;
    for (const Parameter& parameter : technique.parameters) {
      const auto values = without_effect(technique, parameter, points, scene.light());
      if (!values) continue;
      const Start start{*values, visibility(scene, technique.id, *values)};
      EXPECT_FALSE(acts_on(scene, technique, parameter, start)) << parameter.name << " " << to_text(type);
    }
  }
}

TEST_P(EachTechnique, has_no_parameter_without_effect) {
  UMBRAMETER_REQUIRE_GL();
  const auto all = techniques();
  const Technique& technique = *std::ranges::find(all, GetParam(), &Technique::id);
  std::vector<const Parameter*> silent;
  for (const Parameter& parameter : technique.parameters) silent.push_back(&parameter);
  for (const Light& light : {rect_light_above({0.5, 4, 0.3}, {1.0, 0.5}), sphere_light({0.5, 4, 0.3}, 0.5),
                             sun_light({0.3, 1, 0.2}, 0.05)}) {
    if (!is_tried(technique, light.type)) continue;
    Scene scene = busy_scene(light);                                            // some act under a sun only
    if (technique.has_history()) scene.motion = standard_motion("pan", scene);  // some where something moves
    for (const ParameterValues& values : starting_points(technique)) {
      if (silent.empty()) break;
      const Start start{values, visibility(scene, technique.id, values)};
      std::erase_if(silent, [&](const Parameter* p) { return acts_on(scene, technique, *p, start); });
    }
  }
  for (const Parameter* parameter : silent) ADD_FAILURE() << technique.id << "." << parameter->name;
}

std::vector<std::string> technique_ids() {
  std::vector<std::string> ids;
  for (const Technique& technique : techniques()) ids.push_back(technique.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(all, EachTechnique, testing::ValuesIn(technique_ids()),
                         [](const auto& test) { return test.param; });

TEST(every_technique, visibility_is_finite_and_between_0_and_1_for_every_light) {
  UMBRAMETER_REQUIRE_GL();
  Light inside_geometry = rect_light_above({0.9, 0.5, -0.5}, {0.2, 0.2});
  const std::vector<Light> lights = {rect_light_above({0.5, 4, 0.3}, {1.0, 0.5}),
                                     disk_light_above({0.5, 4, 0.3}, 0.5),
                                     sphere_light({0.5, 4, 0.3}, 0.5),
                                     sphere_light({0, 0.1, 0}, 0.3),
                                     sun_light({0.3, 1, 0.2}, 0.05),
                                     sun_light({1, 0.01, 0}, 0.2),
                                     inside_geometry};
  for (const Technique& technique : techniques()) {
    for (const Light& light : lights) {
      if (!technique.supports(light.type)) continue;
      for (const float v :
           visibility(busy_scene(light), technique.id, quick(technique, kMapSize, kLightSamples))) {
        ASSERT_TRUE(v >= 0.0f && v <= 1.0f) << technique.id << " " << to_text(light.type) << " " << v;
      }
    }
  }
}

TEST(every_technique, is_deterministic_for_a_seed) {
  UMBRAMETER_REQUIRE_GL();
  for (const Technique& technique : techniques()) {
    const bool takes_disk = technique.supports(LightType::disk);
    const Scene scene =
        busy_scene(takes_disk ? disk_light_above({0.5, 4, 0.3}, 0.5) : light_at_4(any_light(technique), 1.0));
    const auto first = visibility(scene, technique.id, quick(technique, kMapSize, kLightSamples), 7);
    EXPECT_EQ(first, visibility(scene, technique.id, quick(technique, kMapSize, kLightSamples), 7))
        << technique.id;
  }
}

TEST(every_technique, background_is_lit_and_surfaces_turned_away_are_dark) {
  UMBRAMETER_REQUIRE_GL();
  // A wall facing away from the light, half of the picture; nothing behind it.
  Scene scene;
  add_quad(scene, {0, -5, 0}, {5, -5, 0}, {5, 5, 0}, {0, 5, 0});
  scene.camera.eye_world = {0, 0, 4};
  Light light = rect_light_above({0, 0, -3}, {0.5, 0.5});
  light.tangent_world = {1, 0, 0};
  light.bitangent_world = {0, 1, 0};
  light.direction_world = {0, 0, 1};
  scene.lights = {light};
  finish_scene(scene);
  for (const Technique& technique : techniques()) {
    const LightType type = any_light(technique);
    scene.lights = {light};
    if (type == LightType::sphere) scene.lights = {sphere_light({0, 0, -3}, 0.25)};
    if (type == LightType::sun) scene.lights = {sun_light({0, 0, -1}, 0.05)};
    finish_scene(scene);
    const Frame frame = render(scene, technique.id, quick(technique, kMapSize, kLightSamples));
    const auto v = frame.image.plane("visibility");
    const auto id = frame.image.plane("primitive_id");
    for (size_t i = 0; i < v.size(); ++i)
      ASSERT_EQ(v[i], id[i] < 0.0f ? 1.0f : 0.0f) << technique.id << " " << i;
  }
}

TEST(every_technique, a_plane_does_not_shadow_itself_at_any_slope) {
  UMBRAMETER_REQUIRE_GL();
  // All of the light stays above the horizon: at 75 deg and distance 4 it is 4 cos 75 = 1.04 away from the
  // plane.
  for (const double angle_deg : {0.0, 30.0, 60.0, 75.0}) {
    for (const LightType type : {LightType::rect, LightType::sphere, LightType::sun}) {
      Scene scene;
      add_floor(scene, {3, 3});
      scene =
          moved_scene(scene, glm::rotate(glm::dmat4(1.0), glm::radians(angle_deg), glm::dvec3(0.3, 0, 1)));
      scene.lights = {light_at_4(type, 0.1)};
      const glm::dvec3 normal = triangle_normal_world(scene, 0);
      scene.camera.eye_world = 3.0 * normal + glm::dvec3(0.2, 0.3, 0.1);
      scene.camera.at_world = {0, 0, 0};
      finish_scene(scene);
      for (const Technique& technique : techniques()) {
        if (!is_tried(technique, type)) continue;
        for (const float v : visibility(scene, technique.id, quick(technique, kMapSize, kLightSamples))) {
          ASSERT_EQ(v, 1.0f) << technique.id << " at " << angle_deg << " deg, " << to_text(type);
        }
      }
    }
  }
}

/// Share of pixels that differ by more than a tap or two.
double differing_share(const std::vector<float>& a, const std::vector<float>& b) {
  size_t different = 0;
  for (size_t i = 0; i < a.size(); ++i) different += std::abs(a[i] - b[i]) > 0.15f ? 1 : 0;
  return static_cast<double>(different) / static_cast<double>(a.size());
}

TEST(every_technique, answer_does_not_depend_on_the_unit_of_length) {
  UMBRAMETER_REQUIRE_GL();
  // A power of two scales floats without rounding; bias_world is 0 by default and everything else is
  // relative.
  for (const LightType type : {LightType::rect, LightType::sphere, LightType::sun}) {
    const Scene scene = busy_scene(light_at_4(type, 0.5));
    for (const Technique& technique : techniques()) {
      if (!is_tried(technique, type)) continue;
      const auto scaled =
          visibility(scaled_scene(scene, 64.0), technique.id, quick(technique, kMapSize, kLightSamples));
      EXPECT_LT(
          differing_share(visibility(scene, technique.id, quick(technique, kMapSize, kLightSamples)), scaled),
          1e-3)
          << technique.id << " " << to_text(type);
    }
  }
}

TEST(every_technique, answer_moves_with_the_scene) {
  UMBRAMETER_REQUIRE_GL();
  // A quarter turn about y and a shift by powers of two keep the floats; maps and patterns turn along.
  const glm::dmat4 motion = glm::translate(glm::dmat4(1.0), glm::dvec3(8, -4, 16)) *
                            glm::rotate(glm::dmat4(1.0), glm::radians(90.0), glm::dvec3(0, 1, 0));
  for (const LightType type : {LightType::rect, LightType::sphere, LightType::sun}) {
    const Scene scene = busy_scene(light_at_4(type, 0.5));
    for (const Technique& technique : techniques()) {
      if (!is_tried(technique, type)) continue;
      const auto moved =
          visibility(moved_scene(scene, motion), technique.id, quick(technique, kMapSize, kLightSamples));
      // Shadow outlines may fall to the other side of a texel: a few per cent of the picture are outline.
      EXPECT_LT(
          differing_share(visibility(scene, technique.id, quick(technique, kMapSize, kLightSamples)), moved),
          0.02)
          << technique.id << " " << to_text(type);
    }
  }
}

TEST(pcss, with_a_tiny_light_is_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    const Scene scene = busy_scene(light_at_4(type, 1e-7));
    EXPECT_EQ(visibility(scene, "pcss"), visibility(scene, "hard")) << to_text(type);
  }
}

TEST(pcf, of_no_width_is_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::rect, 0.5));
  EXPECT_EQ(visibility(scene, "pcf", {{"filter_width_texels", 0.0}}), visibility(scene, "hard"));
}

TEST(pcf, one_texel_wide_differs_from_the_hard_shadow_only_at_edges) {
  UMBRAMETER_REQUIRE_GL();
  // A box of one texel reaches 1 texel at most: of this picture's shadow outlines, well under a tenth.
  const Scene scene = busy_scene(light_at_4(LightType::rect, 0.5));
  const auto pcf = visibility(scene, "pcf", {{"filter_width_texels", 1.0}});
  const auto hard = visibility(scene, "hard");
  size_t different = 0;
  for (size_t i = 0; i < pcf.size(); ++i) different += pcf[i] != hard[i] ? 1 : 0;
  EXPECT_GT(different, 0u);
  EXPECT_LT(different, pcf.size() / 10);
}

TEST(pcf, wider_boxes_give_wider_penumbrae) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::rect, 1.0));
  size_t before = 0;
  for (const double width : {1.0, 5.0, 9.5, 33.0}) {
    size_t partial = 0;
    for (const float v :
         visibility(scene, "pcf", {{"filter_width_texels", width}, {"map_size", int64_t{512}}})) {
      partial += v > 0.0f && v < 1.0f ? 1 : 0;
    }
    EXPECT_GT(partial, before) << width;
    before = partial;
  }
}

TEST(pcss, noise_follows_the_seed) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  EXPECT_GT(largest_difference(visibility(scene, "pcss", {}, 1), visibility(scene, "pcss", {}, 2)), 0.0);
  const ParameterValues still{{"noise", false}};
  EXPECT_EQ(visibility(scene, "pcss", still, 1), visibility(scene, "pcss", still, 2));
}

TEST(every_technique, pixels_outside_the_map_are_lit) {
  UMBRAMETER_REQUIRE_GL();
  // A sphere light amid the scene looks towards the receivers' middle; what lies beyond 80 deg off is
  // outside. The wall on the far side of the light faces it and nothing stands between; its rays come in at up to
  // 86 deg, within the 88 deg that the receiver plane is exact for.
  Scene scene;
  add_quad(scene, {-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  scene.lights = {sphere_light({0, 0, 0.4}, 0.01)};
  scene.camera.eye_world = {0, 0, 8};
  finish_scene(scene);
  for (const Technique& technique : techniques()) {
    if (!technique.supports(LightType::sphere)) continue;
    const auto v = visibility(scene, technique.id, quick(technique, kMapSize, kLightSamples));
    EXPECT_EQ(*std::ranges::min_element(v), 1.0f) << technique.id;
  }
}

}  // namespace
}  // namespace umbrameter
