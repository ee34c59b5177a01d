// SPDX-License-Identifier: Apache-2.0
// What must not matter to any technique: where the world's origin is, how the map is fitted, a factor of two in its
// size, an earlier run. And what must not be paid for: resources and passes that the parameters make useless. The
// complaints behind this list are in the issue trackers of most engines.

#include "realtime/graph/expression.h"
#include "realtime/manifest/names.h"
#include "realtime/manifest/technique.h"
#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace umbrameter {
namespace {

using namespace test;

const std::filesystem::path kRealtime = source_dir() / "realtime";

bool has_parameter(const Technique& technique, const std::string& name) {
  return std::ranges::any_of(technique.parameters, [&](const Parameter& p) { return p.name == name; });
}

Light light_for(const Technique& technique) {
  return light_at_4(any_light(technique), 0.5);
}

struct Score {
  double rmse;
  double mean;  // of visibility
};

/// Against the closed form of the half plane, in a world moved by `shift_world` in x and z.
Score score(const Technique& technique, const Light& light, const ParameterValues& values,
            double shift_world = 0.0) {
  const glm::dvec3 shift(shift_world, 0, shift_world);
  const Scene scene = moved_scene(half_plane_scene(light), glm::translate(glm::dmat4(1.0), shift));
  const Frame frame = render(scene, technique.id, values);
  const auto v = frame.image.plane("visibility");
  double sum = 0.0;
  for (const float value : v) sum += value;
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p - shift); };
  return {floor_error(frame, truth).rmse, sum / static_cast<double>(v.size())};
}

/// How much the score may change, by what a family keeps constant. Measured, and about a half more.
struct Bounds {
  double fit;         // everything instead of what is visible: texels four times as large
  double resolution;  // half or twice as many texels per side
};

Bounds bounds_of(const std::string& family) {
  if (family == "hard") return {0.01, 0.005};
  // A width in texels is another width in the world, and the score of the half plane may come to match this light's
  // penumbra: measured 0.036 and 0.033, of 0.08 between a hard shadow and a right one.
  if (family == "filter" || family == "prefiltered" || family == "mask") return {0.05, 0.05};
  // Widths in the world: what is left is the texels' own blur, 0.018 and 0.004.
  return {0.03, 0.02};
}

/// Floats at 1e4 are 1e-3 apart. Measured: 6e-4.
constexpr double kOriginBound = 1e-3;

TEST(every_technique, score_does_not_depend_on_the_origin) {
  UMBRAMETER_REQUIRE_GL();
  for (const Technique& technique : techniques()) {
    for (const LightType type : {LightType::rect, LightType::sun}) {
      if (!technique.supports(type)) continue;
      const Light light = light_at_4(type, 0.5);
      const Score here = score(technique, light, quick(technique));
      const Score far = score(technique, light, quick(technique), 1e4);
      RecordProperty(
          fmt::format("{}-{}", technique.id, to_text(type)),
          fmt::format("{:.4f} {:.4f} mean {:.4f} {:.4f}", here.rmse, far.rmse, here.mean, far.mean));
      EXPECT_NEAR(far.rmse, here.rmse, kOriginBound) << technique.id << " " << to_text(type);
      EXPECT_NEAR(far.mean, here.mean, kOriginBound) << technique.id << " " << to_text(type);
    }
  }
}

TEST(every_technique, score_hardly_depends_on_fit_and_size_of_the_map) {
  UMBRAMETER_REQUIRE_GL();
  for (const Technique& technique : techniques()) {
    if (!has_parameter(technique, "map_size")) continue;
    const Bounds bounds = bounds_of(technique.family);
    const Light light = light_for(technique);
    const double base = score(technique, light, quick(technique)).rmse;
    ParameterValues fitted = quick(technique);
    fitted["map_fit"] = std::string("scene");
    const double all = score(technique, light, fitted).rmse;
    const double half = score(technique, light, quick(technique, 256)).rmse;
    const double twice = score(technique, light, quick(technique, 1024)).rmse;
    RecordProperty(technique.id,
                   fmt::format("{:.4f} fit {:.4f} half {:.4f} twice {:.4f}", base, all, half, twice));
    EXPECT_NEAR(all, base, bounds.fit) << technique.id;
    EXPECT_NEAR(half, base, bounds.resolution) << technique.id;
    EXPECT_NEAR(twice, base, bounds.resolution) << technique.id;
  }
}

TEST(every_technique, draws_the_active_light_of_64) {
  UMBRAMETER_REQUIRE_GL();
  Scene many = plate_scene();
  const Light light = many.lights[0];
  many.lights.clear();
  for (int i = 0; i < 64; ++i) {
    many.lights.push_back(light);
    many.lights.back().center_world.x += 0.02 * i;
  }
  for (const Technique& technique : techniques()) {
    if (!technique.supports(LightType::rect)) continue;
    for (const size_t index : {size_t{0}, size_t{63}}) {
      many.active_light = index;
      Scene one = many;
      one.lights = {many.lights[index]};
      one.active_light = 0;
      const auto picture = visibility(many, technique.id, quick(technique, 256));
      EXPECT_EQ(picture, visibility(one, technique.id, quick(technique, 256)))
          << technique.id << " " << index;
    }
  }
}

TEST(every_technique, picture_does_not_depend_on_what_was_rendered_before) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  std::vector<std::vector<float>> first;
  const std::vector<Technique> all = techniques();
  for (const Technique& technique : all) {
    if (!technique.supports(LightType::rect)) continue;
    first.push_back(visibility(scene, technique.id, quick(technique, 256), 3));
  }
  size_t index = 0;
  for (const Technique& technique : all) {
    if (!technique.supports(LightType::rect)) continue;
    const auto again = visibility(scene, technique.id, quick(technique, 256), 3);
    EXPECT_EQ(again, first[index++]) << technique.id;
  }
}

// --- what a set of parameters needs, from the manifest alone ---

const std::map<std::string, uint64_t> kTexelBytes = {{"depth32f", 4}, {"depth32f_stencil8", 8},
                                                     {"r8", 1},       {"r16f", 2},
                                                     {"r32f", 4},     {"rg16f", 4},
                                                     {"rg32f", 8},    {"rgba8", 4},
                                                     {"rgba16f", 8},  {"rgba32f", 16},
                                                     {"r32ui", 4},    {"rgba16", 8},
                                                     {"rg32ui", 8},   {"rg16", 4}};

ExpressionVariables variables_for(const Technique& technique, const ParameterValues& values) {
  ExpressionVariables variables = parameter_variables(technique.parameters, values);
  const Light light = light_for(technique);
  const bool is_sun = light.type == LightType::sun;
  const double extent = is_sun                          ? 2.0 * std::tan(light.half_angle_rad)
                        : light.type == LightType::rect ? light.size_world.x
                                                        : 2.0 * light.radius_world;
  variables["screen.width"] = 160;
  variables["screen.height"] = 90;
  variables["light.width"] = variables["light.height"] = extent;
  variables["light.type"] = static_cast<double>(light.type);
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun})
    variables[fmt::format("light.{}", to_text(type))] = static_cast<double>(type);
  // No size or condition may hang on these; values need some.
  for (const auto& [name, value] :
       {std::pair("scene.diagonal", 20.0), std::pair("camera.near", 0.01), std::pair("camera.far", 20.0),
        std::pair("receivers.near", 1.0), std::pair("receivers.far", 10.0)})
    variables[name] = value;
  for (const ValueDeclaration& value : technique.values)
    variables[value.name] = value.value.evaluate(variables);
  return variables;
}

double value_or(const Expression& expression, const ExpressionVariables& variables, double otherwise) {
  return expression.is_empty() ? otherwise : expression.evaluate(variables);
}

bool is_on(const Expression& condition, const ExpressionVariables& variables) {
  return value_or(condition, variables, 1.0) != 0.0;
}

uint64_t bytes_of(const ResourceDeclaration& resource, const ExpressionVariables& variables) {
  auto width = static_cast<uint64_t>(resource.width.evaluate(variables));
  auto height = static_cast<uint64_t>(resource.height.evaluate(variables));
  const auto levels = static_cast<int>(value_or(resource.levels, variables, 1));
  const auto samples = static_cast<uint64_t>(value_or(resource.samples, variables, 1));
  const auto layers = resource.kind == TextureKind::cube
                          ? uint64_t{6}
                          : static_cast<uint64_t>(value_or(resource.layers, variables, 1));
  const std::string& format = resource.format(variables);
  const uint64_t texel = kTexelBytes.at(format);
  const uint64_t several = samples > 1 ? samples * width * height * texel : 0;
  if (several > 0 && format == "depth32f") return several;  // is not resolved
  uint64_t bytes = 0;
  for (int level = 0; level < levels; ++level) {
    bytes += width * height * layers * texel;
    width = std::max<uint64_t>(1, width / 2);
    height = std::max<uint64_t>(1, height / 2);
  }
  return several + bytes;
}

/// Passes that run at least once, in order.
void collect_running(const std::vector<PassDeclaration>& passes, ExpressionVariables variables,
                     std::vector<const PassDeclaration*>& running) {
  for (const PassDeclaration& pass : passes) {
    if (!is_on(pass.condition, variables)) continue;
    if (pass.kind != PassKind::loop) {
      if (std::ranges::find(running, &pass) == running.end()) running.push_back(&pass);
      continue;
    }
    const auto count = static_cast<int>(pass.loop_count.evaluate(variables));
    variables[pass.loop_variable + "_count"] = count;
    for (int i = 0; i < count; ++i) {
      variables[pass.loop_variable] = i;
      collect_running(pass.body, variables, running);
    }
  }
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Defaults, every preset, every other value of a boolean or a choice.
std::vector<ParameterValues> settings(const Technique& technique) {
  std::vector<ParameterValues> all = {{}};
  for (const Preset& preset : technique.presets) all.push_back(preset.values);
  for (const Parameter& parameter : technique.parameters) {
    if (parameter.type == ParameterType::boolean)
      all.push_back({{parameter.name, !std::get<bool>(parameter.default_value)}});
    for (const std::string& choice : parameter.choices) all.push_back({{parameter.name, choice}});
  }
  return all;
}

/// Empty when the values break a constraint.
std::optional<ParameterValues> resolved(const Technique& technique, const ParameterValues& values) {
  try {
    return resolve_parameters(technique, values);
  } catch (const Error&) {
    return {};
  }
}

void expect_nothing_idle(const Technique& technique, const ParameterValues& values, const std::string& what) {
  const ExpressionVariables variables = variables_for(technique, values);
  std::vector<const PassDeclaration*> running;
  collect_running(technique.passes, variables, running);
  const auto is_read = [&](const std::string& name) {
    return std::ranges::any_of(running, [&](const auto* pass) {
      return contains(pass->reads, name) || contains(pass->reads, std::string(kPrevious) + name) ||
             (contains(pass->writes, name) && contains(pass->writes, std::string(kVisibility)));  // tested
    });
  };
  for (const ResourceDeclaration& resource : technique.resources) {
    if (!is_on(resource.condition, variables)) continue;
    const bool is_written =
        std::ranges::any_of(running, [&](const auto* pass) { return contains(pass->writes, resource.name); });
    const bool is_depth_test = resource.format(variables).starts_with("depth32f") && is_written;
    EXPECT_TRUE(is_written && (is_depth_test || is_read(resource.name)))
        << what << ": resource " << resource.name << " is allocated for nothing";
  }
  for (const PassDeclaration* pass : running) {
    const bool is_needed = std::ranges::any_of(
        pass->writes, [&](const std::string& name) { return name == kVisibility || is_read(name); });
    EXPECT_TRUE(is_needed) << what << ": pass " << pass->id << " runs for nothing";
  }
}

TEST(every_technique, allocates_and_draws_only_what_its_parameters_need) {
  for (const Technique& technique : techniques()) {
    for (const ParameterValues& values : settings(technique)) {
      const auto complete = resolved(technique, values);
      if (!complete) continue;
      std::string what = technique.id;
      for (const auto& [name, value] : values) what += fmt::format(" {}={}", name, to_text(value));
      expect_nothing_idle(technique, *complete, what);
    }
  }
}

/// Of the data that passes read of a scene without instances.
uint64_t scene_data_bytes(const std::vector<PassDeclaration>& passes, const Scene& scene) {
  const uint64_t vertices = scene.positions_world.size(), triangles = scene.triangles.size();
  uint64_t bytes = 0;
  if (reads(passes, "scene.positions")) bytes += 12 * vertices;
  if (reads(passes, "scene.triangles")) bytes += 12 * triangles;
  if (reads(passes, "scene.normals")) bytes += std::max<uint64_t>(4, 12 * scene.normals_world.size());
  if (reads(passes, "scene.adjacency")) bytes += 12 * triangles;
  if (reads(passes, "scene.bvh")) bytes += 64 * triangles;
  return bytes;
}

TEST(every_technique, memory_and_timed_passes_are_those_of_its_manifest) {
  UMBRAMETER_REQUIRE_GL();
  const auto renderer = make_realtime_renderer({kRealtime / "techniques", kRealtime / "shaders", {}});
  for (const Technique& technique : techniques()) {
    RenderRequest request;
    request.width_px = 160;
    request.height_px = 90;
    request.technique = technique.id;
    request.parameters = quick(technique, 128);
    SilentProgress progress;
    const Scene scene = half_plane_scene(light_for(technique));
    const PreparedRun run = renderer->prepare(scene, request, progress);
    const Frame& frame = run.frame;
    const ExpressionVariables variables = variables_for(technique, frame.parameters);

    uint64_t bytes = scene_data_bytes(technique.passes, scene);
    const std::set<std::string> previously = read_previously(technique.passes);  // two of each
    for (const ResourceDeclaration& resource : technique.resources)
      if (is_on(resource.condition, variables))
        bytes += (previously.contains(resource.name) ? 2 : 1) * bytes_of(resource, variables);
    for (const BufferDeclaration& buffer : technique.buffers)
      if (is_on(buffer.condition, variables))
        bytes += (previously.contains(buffer.name) ? 2 : 1) *
                 static_cast<uint64_t>(buffer.count.evaluate(variables)) * buffer.element->bytes();
    EXPECT_EQ(frame.memory_bytes, bytes) << technique.id;

    std::vector<const PassDeclaration*> running;
    collect_running(technique.passes, variables, running);
    std::set<std::string> expected;
    for (const PassDeclaration* pass : running)
      if (!pass->once) expected.insert(pass->timer.empty() ? pass->id : pass->timer);
    EXPECT_EQ(std::set<std::string>(run.passes.begin(), run.passes.end()), expected) << technique.id;
  }
}

}  // namespace
}  // namespace umbrameter
