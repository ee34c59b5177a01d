// SPDX-License-Identifier: Apache-2.0
// A map that stays between two values of a bias must change no pixel, must really stay, and must go when what it was drawn
// by has changed.

#include "realtime/inspect.h"
#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <memory>

namespace umbrameter {
namespace {

using namespace test;

std::unique_ptr<Renderer> renderer_that(bool keeps) {
  RealtimeSettings settings;
  settings.techniques_folder = source_dir() / "realtime/techniques";
  settings.shaders_folder = source_dir() / "realtime/shaders";
  settings.keep_textures = keeps;
  return make_realtime_renderer(settings);
}

RenderRequest request_of(const std::string& technique, const ParameterValues& values) {
  return {96, 54, 1, technique, values};
}

std::vector<float> picture(Renderer& renderer, const Scene& scene, const std::string& technique,
                           const ParameterValues& values) {
  SilentProgress progress;
  const Frame frame = renderer.render(scene, request_of(technique, values), progress);
  const auto plane = frame.image.plane("visibility");
  return {plane.begin(), plane.end()};
}

/// Around the quick values: each parameter that a tuner may move, moved once and put back; of macros, each of which is another
/// shader to compile, the first.
std::vector<ParameterValues> moves(const Technique& technique) {
  const ParameterValues start = quick(technique, 128, 4);
  std::vector<ParameterValues> all{start};
  size_t macros = 0;
  for (const Parameter& parameter : technique.parameters) {
    if (!parameter.tune || (parameter.stage == ParameterStage::define && macros++ > 0)) continue;
    if (parameter.type == ParameterType::boolean)
      all.push_back(with(start, {{parameter.name, !std::get<bool>(parameter.default_value)}}));
    if (parameter.type == ParameterType::choice)
      all.push_back(with(start, {{parameter.name, parameter.choices.back()}}));
    if (parameter.type == ParameterType::real && !parameter.is_relative_to_scene)
      all.push_back(with(start, {{parameter.name, 0.5 * (parameter.min + parameter.max)}}));
  }
  all.push_back(start);
  return all;
}

TEST(KeptTextures, ChangeNoPixelOfAnyTechnique) {
  UMBRAMETER_REQUIRE_GL();
  const auto keeping = renderer_that(true), drawing = renderer_that(false);
  for (const Technique& technique : techniques()) {
    const Scene scene = busy_scene(light_at_4(any_light(technique), 0.5));
    for (const ParameterValues& values : moves(technique)) {
      std::vector<float> expected;
      try {
        expected = picture(*drawing, scene, technique.id, values);
      } catch (const Error&) {  // constraints of the technique
        continue;
      }
      EXPECT_EQ(picture(*keeping, scene, technique.id, values), expected) << technique.id;
    }
  }
  EXPECT_EQ(pass_counts(*drawing).kept, 0u);
  EXPECT_GT(pass_counts(*keeping).kept, 200u);
}

/// Passes drawn by the last of two frames.
class Counted {
 public:
  Counted() : renderer_(renderer_that(true)) {}
  uint64_t operator()(const Scene& scene, const std::string& technique, const ParameterValues& values) {
    const uint64_t before = pass_counts(*renderer_).drawn;
    picture(*renderer_, scene, technique, values);
    return pass_counts(*renderer_).drawn - before;
  }
  Renderer& renderer() { return *renderer_; }

 private:
  std::unique_ptr<Renderer> renderer_;
};

TEST(KeptTextures, EvaluationsOfABiasDrawTheMapOnceACamera) {
  UMBRAMETER_REQUIRE_GL();
  Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  Counted drawn;
  const auto bias = [&](double texels) {
    return drawn(scene, "pcf_disk", {{"map_size", int64_t{128}}, {"bias_texels", texels}});
  };
  EXPECT_EQ(bias(0.1), 2u);  // the map, the picture
  for (const double texels : {0.2, 0.4, 0.8}) EXPECT_EQ(bias(texels), 1u);
  const Camera own = scene.camera;
  scene.camera.eye_world.x += 0.3;
  EXPECT_EQ(bias(0.1), 2u);
  EXPECT_EQ(bias(0.2), 1u);
  scene.camera = own;
  EXPECT_EQ(bias(1.6), 1u);  // both cameras' maps are there
}

TEST(KeptTextures, GoWhenWhatTheyWereDrawnByHasChanged) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  Counted drawn;
  const auto with_values = [&](const ParameterValues& more) {
    return drawn(scene, "pcf_disk", with({{"map_size", int64_t{128}}}, more));
  };
  EXPECT_EQ(with_values({}), 2u);
  EXPECT_EQ(with_values({{"bilinear", false}}), 1u);  // a macro that the map's shader does not name
  EXPECT_EQ(with_values({{"map_size", int64_t{256}}}), 2u);
  EXPECT_EQ(with_values({{"slope_bias", 1.0}}), 2u);
  EXPECT_EQ(with_values({{"slope_bias", 2.0}}), 2u);  // a uniform that it does
  EXPECT_EQ(with_values({{"slope_bias", 2.0}, {"bias_texels", 3.0}}), 1u);
  EXPECT_EQ(with_values({{"caster_layer", std::string("midpoint")}}), 4u);
  EXPECT_EQ(with_values({{"caster_layer", std::string("back_faces")}}), 2u);
  EXPECT_EQ(with_values({}), 1u);
}

TEST(KeptTextures, TimedFramesDrawEverything) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  const auto renderer = renderer_that(true);
  const ParameterValues values = {{"map_size", int64_t{128}}};
  const std::vector<float> before = picture(*renderer, scene, "pcf_disk", values);
  const PassCounts counts = pass_counts(*renderer);
  SilentProgress progress;
  const PreparedRun run = renderer->prepare(scene, request_of("pcf_disk", values), progress);
  EXPECT_EQ(run.passes.size(), 2u);
  EXPECT_EQ(run.time_frame().size(), 2u);
  EXPECT_EQ(pass_counts(*renderer).kept, counts.kept);
  const auto plane = run.frame.image.plane("visibility");
  EXPECT_EQ(std::vector<float>(plane.begin(), plane.end()), before);
}

}  // namespace
}  // namespace umbrameter
