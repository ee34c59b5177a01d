// SPDX-License-Identifier: Apache-2.0
// Without these, what a manifest says and what GL does could part: sizes, loops, blending, culling,
// conditions, views, timings.

#include "core/files.h"
#include "scenes/scene.h"
#include "tests/gpu/tried_technique.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

constexpr int kSidePx = 48;

std::string parameter(const std::string& name, const std::string& rest) {
  return "[[parameter]]\nname = \"" + name + "\"\ndoc = \"x\"\n" + rest + "\n";
}

std::string fullscreen(const std::string& id, const std::string& rest) {
  return "[[pass]]\nid = \"" + id + "\"\nkind = \"fullscreen\"\n" + rest + "\n";
}

std::string map_resource(const std::string& size) {
  return "[[resource]]\nname = \"map\"\nformat = \"depth32f\"\nwidth = " + size + "\nheight = " + size + "\n";
}

constexpr std::string_view kMapPass =
    "[[pass]]\nid = \"map\"\nkind = \"scene\"\nview = \"light\"\nwrites = [\"map\"]\nclear = [0]\n";
constexpr std::string_view kCenterView = "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 64\n";

/// A floor of 4 x 4 under a closed box of side 1 that floats at height 1 to 2, a rect light of side 0.2 at
/// height 4, the camera above looking at the middle 3 x 3. From the light's centre the box shades the square
/// of side 4 / (4 - 2) = 2 on the floor.
Scene box_over_floor() {
  Scene scene;
  add_floor(scene, {4, 4});
  add_box(scene, {-0.5, 1, -0.5}, {0.5, 2, 0.5});
  scene.camera = camera_above({0, 0, 0}, 3, 20);
  scene.lights.push_back(rect_light_above({0, 4, 0}, {0.2, 0.2}));
  finish_scene(scene);
  return scene;
}

class Executor : public TriedTechnique {
 protected:
  Executor() : TriedTechnique(box_over_floor(), kSidePx) {}

  void write_manifest(const std::string& body) { folder_.write("technique.toml", manifest_head() + body); }

  using TriedTechnique::render;
  Frame render(const ParameterValues& parameters, uint64_t seed) {
    RenderRequest seeded = request(parameters);
    seeded.seed = seed;
    SilentProgress progress;
    return renderer_->render(scene_, seeded, progress);
  }

  /// Visibility at the pixel that shows the floor point (x, z). The camera's up is -z, so rows grow with z.
  static float at(const Frame& frame, double x, double z) {
    const auto pixel = [](double lateral) { return static_cast<size_t>((lateral / 3.0 + 0.5) * kSidePx); };
    return frame.image.plane("visibility")[pixel(z) * kSidePx + pixel(x)];
  }
};

TEST_F(Executor, ConstantFillsTheScreen) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag", "void main() { out_visibility = 0.25; }");
  const Frame frame = render();
  EXPECT_THAT(
      std::vector<float>(frame.image.plane("visibility").begin(), frame.image.plane("visibility").end()),
      Each(0.25f));
  EXPECT_EQ(frame.memory_bytes, 0u);
  EXPECT_TRUE(frame.image.has("position.x"));
  EXPECT_TRUE(frame.warnings.empty()) << frame.warnings.front();
}

TEST_F(Executor, EmptyTechniqueRendersTheGBufferOnly) {
  RenderRequest request;
  request.width_px = kSidePx;
  request.height_px = kSidePx;
  SilentProgress progress;
  const Frame frame = renderer_->render(scene_, request, progress);
  EXPECT_TRUE(frame.image.has("unshadowed_irradiance"));
  EXPECT_FALSE(frame.image.has("visibility"));
}

TEST_F(Executor, PixelsOfTheShaderAreThoseOfTheImage) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag", "void main() { out_visibility = gl_FragCoord.y / frame.screen_and_seed.y; }");
  const Frame frame = render();
  // GL's lowest row, at y = 0.5, is the image's last.
  EXPECT_FLOAT_EQ(frame.image.plane("visibility")[(kSidePx - 1) * kSidePx], 0.5f / kSidePx);
  EXPECT_FLOAT_EQ(frame.image.plane("visibility")[0], (kSidePx - 0.5f) / kSidePx);
}

TEST_F(Executor, ParametersReachTheShader) {
  write_manifest(
      parameter("amount", "type = \"real\"\ndefault = 0.5\nmin = 0\nmax = 1\nstage = \"uniform\"") +
      parameter("count", "type = \"integer\"\ndefault = 3\nmin = 1\nmax = 9\nstage = \"uniform\"") +
      parameter("scale", "type = \"real\"\ndefault = 1\nmin = 0\nmax = 1\nstage = \"define\"") +
      parameter("shape",
                "type = \"choice\"\nchoices = [\"box\", \"disk-8\"]\ndefault = \"box\"\nstage = \"define\"") +
      fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag",
                "void main() { out_visibility = SCALE * amount / float(count) + (SHAPE == SHAPE_DISK_8 ? "
                "0.25 : 0.0); }");
  EXPECT_FLOAT_EQ(render().image.plane("visibility")[0], 0.5f / 3.0f);
  const Frame frame =
      render({{"amount", 1.0}, {"count", int64_t{4}}, {"scale", 0.5}, {"shape", std::string("disk-8")}});
  EXPECT_FLOAT_EQ(frame.image.plane("visibility")[0], 0.5f * 1.0f / 4.0f + 0.25f);
  EXPECT_EQ(std::get<int64_t>(frame.parameters.at("count")), 4);
}

TEST_F(Executor, LoopAddsItsIterations) {
  write_manifest(parameter("rounds", "type = \"integer\"\ndefault = 4\nmin = 1\nmax = 9\nstage = \"host\"") +
                 fullscreen("start", "fragment = \"start.frag\"\nwrites = [\"visibility\"]") +
                 "[[pass]]\nid = \"loop\"\nkind = \"loop\"\nvariable = \"k\"\ncount = \"rounds\"\n"
                 "[[pass.pass]]\nid = \"add\"\nkind = \"fullscreen\"\nfragment = \"add.frag\"\nwrites = "
                 "[\"visibility\"]\n"
                 "blend = \"add\"\ncondition = \"k > 0\"\n");
  folder_.write("start.frag", "void main() { out_visibility = 0.125; }");
  folder_.write("add.frag", "void main() { out_visibility = float(k) / (16.0 * k_count); }");
  // 1/8 + (1 + 2 + 3) / (16 * 4)
  EXPECT_FLOAT_EQ(render().image.plane("visibility")[7], 0.125f + 6.0f / 64.0f);
}

TEST_F(Executor, TargetsPassValuesOnAtTheirOwnSize) {
  write_manifest(
      "[[resource]]\nname = \"small\"\nformat = \"rg16f\"\nwidth = \"ceil(screen.width / 2)\"\nheight = 5\n" +
      fullscreen("first", "fragment = \"first.frag\"\nwrites = [\"small\"]") +
      fullscreen("second", "fragment = \"second.frag\"\nreads = [\"small\"]\nwrites = [\"visibility\"]"));
  folder_.write("first.frag", "void main() { out_small = vec2(gl_FragCoord.x / 64.0, 0.5); }");
  folder_.write(
      "second.frag",
      "void main() { out_visibility = texelFetch(small, ivec2(small_size.xy) - 1, 0).x * small_size.w; }");
  const Frame frame = render();
  // The last column of 24 is at x = 23.5; 1 / height = 1/5.
  EXPECT_FLOAT_EQ(frame.image.plane("visibility")[0], 23.5f / 64.0f / 5.0f);
  EXPECT_EQ(frame.memory_bytes, 24u * 5u * 4u);
}

TEST_F(Executor, ConditionLeavesAResourceOut) {
  write_manifest(
      parameter("blur", "type = \"boolean\"\ndefault = true\nstage = \"host\"") +
      "[[resource]]\nname = \"spare\"\nformat = \"rgba32f\"\nwidth = 8\nheight = 8\ncondition = \"blur\"\n" +
      fullscreen("fill", "fragment = \"fill.frag\"\nwrites = [\"spare\"]\ncondition = \"blur\"") +
      fullscreen("all", "fragment = \"all.frag\"\nreads = [\"spare\"]\nwrites = [\"visibility\"]"));
  folder_.write("fill.frag", "void main() { out_spare = vec4(0.75); }");
  folder_.write("all.frag",
                "void main() {\n#ifdef spare_size\nout_visibility = texelFetch(spare, ivec2(0), "
                "0).x;\n#else\nout_visibility = 0.5;\n#endif\n}");
  const Frame with = render();
  EXPECT_EQ(with.memory_bytes, 8u * 8u * 16u);
  EXPECT_FLOAT_EQ(with.image.plane("visibility")[0], 0.75f);
  const Frame without = render({{"blur", false}});
  EXPECT_EQ(without.memory_bytes, 0u);
  EXPECT_FLOAT_EQ(without.image.plane("visibility")[0], 0.5f);
}

TEST_F(Executor, WritingALeftOutResourceIsAnError) {
  write_manifest(
      parameter("blur", "type = \"boolean\"\ndefault = true\nstage = \"host\"") +
      "[[resource]]\nname = \"spare\"\nformat = \"r8\"\nwidth = 8\nheight = 8\ncondition = \"blur\"\n" +
      fullscreen("fill", "fragment = \"fill.frag\"\nwrites = [\"spare\"]") +
      fullscreen("all", "fragment = \"all.frag\"\nreads = [\"spare\"]\nwrites = [\"visibility\"]"));
  folder_.write("fill.frag", "void main() { out_spare = 0.75; }");
  folder_.write("all.frag", "void main() { out_visibility = texelFetch(spare, ivec2(0), 0).x; }");
  EXPECT_THAT(error_of({{"blur", false}}),
              AllOf(HasSubstr("pass 'fill' writes 'spare', whose condition does not hold"),
                    HasSubstr("technique.toml:")));
}

constexpr std::string_view kHardShader = R"(#include "spaces.glsl"
void main() {
  vec3 p_light = (view_light.light_from_world * vec4(texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0).xyz, 1.0)).xyz;
  vec4 p_clip = view_light.clip_from_light * vec4(p_light, 1.0);
  float stored = texelFetch(map, ivec2((0.5 * p_clip.xy / p_clip.w + 0.5) * map_size.xy), 0).r;
  out_visibility = p_clip.z / p_clip.w >= stored - 0.001 ? 1.0 : 0.0;
}
)";

std::string hard_passes(const std::string& map_keys) {
  return std::string(kMapPass) + map_keys + "\n" +
         fullscreen("resolve",
                    "fragment = \"hard.frag\"\nviews = [\"light\"]\nreads = [\"gbuffer.position\", "
                    "\"map\"]\nwrites = [\"visibility\"]");
}

TEST_F(Executor, MapFromTheLightCastsTheShadowWhereSimilarTrianglesPutIt) {
  folder_.write("hard.frag", kHardShader);
  write_manifest(std::string(kCenterView) + map_resource("64") + hard_passes(""));
  const Frame frame = render();
  // The shadow ends at |x| = 1; a texel of the 64 map over 4 world units is 1/16.
  EXPECT_EQ(at(frame, 0.9, 0.0), 0.0f);
  EXPECT_EQ(at(frame, -0.9, 0.9), 0.0f);
  EXPECT_EQ(at(frame, 1.1, 0.0), 1.0f);
  EXPECT_EQ(at(frame, 0.0, -1.1), 1.0f);
  EXPECT_EQ(frame.memory_bytes, 64u * 64u * 4u);
}

// With back faces culled the map holds the box's top at distance 2, otherwise its bottom at distance 3; the
// floor (single-sided, facing the light) is at 4 and drops out when front faces are culled.
TEST_F(Executor, CullingFollowsTheWindingOfTheScene) {
  folder_.write("depth.frag", R"(void main() {
  float stored = texelFetch(map, ivec2(32), 0).r;
  float near = view_light.depth_range.x, far = view_light.depth_range.y;
  out_visibility = 0.1 * near * far / (near + stored * (far - near));
})");
  const auto middle = [&](const std::string& cull) {
    write_manifest(
        std::string(kCenterView) + map_resource("64") + std::string(kMapPass) + "cull = \"" + cull + "\"\n" +
        fullscreen(
            "resolve",
            "fragment = \"depth.frag\"\nviews = [\"light\"]\nreads = [\"map\"]\nwrites = [\"visibility\"]"));
    return render().image.plane("visibility")[0] * 10.0f;
  };
  EXPECT_NEAR(middle("none"), 2.0f, 1e-3f);
  EXPECT_NEAR(middle("back"), 2.0f, 1e-3f);
  EXPECT_NEAR(middle("front"), 3.0f, 1e-3f);
}

TEST_F(Executor, SampleViewsDifferByIterationAndSeed) {
  folder_.write("hard.frag", replaced(std::string(kHardShader), "1.0 : 0.0;", "1.0 / i_count : 0.0;"));
  folder_.write("start.frag", "void main() { out_visibility = 0.0; }");
  write_manifest(
      "[[view]]\nname = \"light\"\nfrom = \"light.sample(i)\"\nfit = \"scene\"\nsize = 128\n" +
      map_resource("128") + fullscreen("start", "fragment = \"start.frag\"\nwrites = [\"visibility\"]") +
      "[[pass]]\nid = \"loop\"\nkind = \"loop\"\nvariable = \"i\"\ncount = 16\n" +
      "[[pass.pass]]\nid = \"map\"\nkind = \"scene\"\nview = \"light\"\nwrites = [\"map\"]\nclear = [0]\n" +
      "[[pass.pass]]\nid = \"add\"\nkind = \"fullscreen\"\nfragment = \"hard.frag\"\nviews = [\"light\"]\n"
      "reads = [\"gbuffer.position\", \"map\"]\nwrites = [\"visibility\"]\nblend = \"add\"\n");
  const Frame frame = render();
  // On the floor the light of side 0.2 at height 4 blurs the edge of the box's top (height 2) over 0.2,
  // around 1.
  EXPECT_NEAR(at(frame, 0.8, 0.0), 0.0f, 1e-5f);
  EXPECT_NEAR(at(frame, 1.2, 0.0), 1.0f, 1e-5f);
  EXPECT_GT(at(frame, 1.0, 0.0), 0.1f);
  EXPECT_LT(at(frame, 1.0, 0.0), 0.9f);
  EXPECT_EQ(frame.image.planes, render().image.planes);  // same seed, same bits
  EXPECT_NE(frame.image.planes, render({}, 2).image.planes);
}

TEST_F(Executor, APreparedRunTimesItsPassesAndShowsWhatARenderShows) {
  folder_.write("hard.frag", kHardShader);
  write_manifest(std::string(kCenterView) + map_resource("64") + hard_passes("timer = \"shadow map\""));
  const PreparedRun run = prepare();
  EXPECT_EQ(run.passes, (std::vector<std::string>{"shadow map", "resolve"}));
  EXPECT_FALSE(run.timer.empty());
  EXPECT_EQ(run.frame.image.planes, render().image.planes);
  for (int frame = 0; frame < 3; ++frame) {
    const std::vector<double> times_ms = run.time_frame();
    ASSERT_EQ(times_ms.size(), 2u);
    for (const double ms : times_ms) EXPECT_GT(ms, 0.0);
  }
}

TEST_F(Executor, PreparedRunsOutliveOtherScenesAndEachOther) {
  folder_.write("hard.frag", kHardShader);
  write_manifest(std::string(kCenterView) + map_resource("64") + hard_passes("timer = \"shadow map\""));
  std::optional<PreparedRun> first = prepare();
  const Image before = first->frame.image;
  Scene bare;
  add_floor(bare, {3.0, 3.0});
  bare.camera = scene_.camera;
  bare.lights = scene_.lights;
  finish_scene(bare);
  SilentProgress progress;
  const PreparedRun second = renderer_->prepare(bare, request({}), progress);
  EXPECT_EQ(first->time_frame().size(), 2u);
  first.reset();
  EXPECT_EQ(second.time_frame().size(), 2u);
  EXPECT_NE(second.frame.image.planes, before.planes);
  EXPECT_EQ(render().image.planes, before.planes);
}

TEST_F(Executor, CompileErrorsPointIntoTheUsersFile) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag", "// first\nvoid main() {\n  out_visibility = nonsense;\n}\n");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("all.frag:3"), HasSubstr("nonsense")));
}

TEST_F(Executor, NaNIsAnErrorWithItsPixel) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag",
                "void main() { out_visibility = ivec2(gl_FragCoord.xy) == ivec2(5, 0) ? "
                "sqrt(-gl_FragCoord.x) : 1.0; }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("'tried'"), HasSubstr("nan"), HasSubstr("(5, 47)")));
}

TEST_F(Executor, ValuesOutsideTheRangeAreAWarning) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag", "void main() { out_visibility = gl_FragCoord.x < 2.0 ? 1.5 : 1.00005; }");
  const Frame frame = render();
  ASSERT_EQ(frame.warnings.size(), 1u);
  EXPECT_THAT(frame.warnings[0],
              AllOf(HasSubstr("96 pixels"), HasSubstr("1.5 at (0, 0)")));  // two columns of 48
}

TEST_F(Executor, ReceiversOutsideTheMapAreAWarning) {
  folder_.write("hard.frag", kHardShader);
  write_manifest(std::string(kCenterView) + map_resource("64") + hard_passes(""));
  scene_ = {};
  add_floor(scene_, {40, 40});
  scene_.camera = camera_above({0, 0, 0}, 3, 20);
  scene_.lights.push_back(rect_light_above({0, 0.1, 0}, {0.1, 0.1}));  // sees up to 0.1 tan(80 deg) = 0.57
  finish_scene(scene_);
  const Frame frame = render();
  ASSERT_EQ(frame.warnings.size(), 1u);
  // Inside: (2 * 0.567 / 3)^2 = 14.3 % of the picture.
  EXPECT_THAT(frame.warnings[0], HasSubstr("% of the receivers lie outside the light's map"));
}

TEST_F(Executor, BadSizesAreErrors) {
  folder_.write("hard.frag", kHardShader);
  write_manifest(std::string(kCenterView) + map_resource("2000000") + hard_passes(""));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("map"), HasSubstr("2000000"), HasSubstr("technique.toml:")));
  write_manifest(std::string(kCenterView) + map_resource("\"screen.width / 5\"") + hard_passes(""));
  EXPECT_THAT(error_of(),
              AllOf(HasSubstr("width of resource 'map'"), HasSubstr("9.6"), HasSubstr("whole number")));
}

TEST_F(Executor, BadResolutionsAreErrors) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag", "void main() { out_visibility = 1.0; }");
  SilentProgress progress;
  for (const int width_px : {0, -3, 100000}) {
    RenderRequest request;
    request.width_px = width_px;
    request.height_px = 16;
    request.technique = "tried";
    EXPECT_THROW(renderer_->render(scene_, request, progress), Error) << width_px;
  }
}

TEST_F(Executor, UnsupportedLightSaysWhichAreSupported) {
  write_manifest(fullscreen("all", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  folder_.write("all.frag", "void main() { out_visibility = 1.0; }");
  scene_.lights[0] = sphere_light({0, 4, 0}, 0.1);
  EXPECT_THAT(error_of(), AllOf(HasSubstr("does not support sphere lights"), HasSubstr("rect, sun")));
}

TEST_F(Executor, ChangedSceneIsNoticed) {
  RenderRequest request;
  request.width_px = kSidePx;
  request.height_px = kSidePx;
  SilentProgress progress;
  const Frame before = renderer_->render(scene_, request, progress);
  scene_.lights[0].center_world.y = 8;  // the caller moves the light without a new hash
  const Frame after = renderer_->render(scene_, request, progress);
  const auto irradiance = [](const Frame& frame) { return frame.image.plane("unshadowed_irradiance")[0]; };
  EXPECT_LT(irradiance(after), irradiance(before));
}

}  // namespace
}  // namespace umbrameter
