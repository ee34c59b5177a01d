// SPDX-License-Identifier: Apache-2.0
#include "lab/temporal.h"

#include "core/error.h"
#include "lab/scene_run.h"
#include "results/guard.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

// Fractions of the golden ratio and of the square root of two: no multiple of them is close to a whole number.
constexpr double kGolden = 0.6180339887498949;
constexpr double kAside_px = 3.0 + kGolden;
constexpr double kUp_px = std::numbers::sqrt2;
constexpr double kLightStep = 0.01 * kGolden;
constexpr int kTemporalSeeds = 3;

constexpr std::array kReferenceChannels = {
    "half_a",   "half_b",   "position.x", "position.y",   "position.z",
    "normal.x", "normal.y", "normal.z",   "primitive_id", "unshadowed_irradiance"};

void move_camera(Camera& camera, int k, int height_px) {
  const glm::dvec3 ahead = camera.at_world - camera.eye_world;
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, camera.up_world));
  const glm::dvec3 up = glm::normalize(glm::cross(right, ahead));
  const double half_angle_rad = 0.5 * camera.vertical_fov_deg * std::numbers::pi / 180.0;
  const double px_world = 2.0 * glm::length(ahead) * std::tan(half_angle_rad) / height_px;
  const glm::dvec3 step = px_world * (kAside_px * right + kUp_px * up);
  camera.eye_world += static_cast<double>(k) * step;
  camera.at_world += static_cast<double>(k) * step;
}

void move_light(Light& light, const glm::dvec3& at_world, int k) {
  const double angle_rad = kLightStep * k;
  if (light.type != LightType::sun) {
    light.center_world += glm::length(light.center_world - at_world) * angle_rad * light.tangent_world;
    return;
  }
  const glm::dvec3 direction = light.direction_world, tangent = light.tangent_world;
  light.direction_world = std::cos(angle_rad) * direction + std::sin(angle_rad) * tangent;
  light.tangent_world = std::cos(angle_rad) * tangent - std::sin(angle_rad) * direction;
}

Image only(const Image& image, std::span<const char* const> channels) {
  Image kept(image.width, image.height);
  for (const char* channel : channels) kept.planes[channel] = image.planes.at(channel);
  return kept;
}

RenderRequest request_of(const SceneContext& context, const TechniqueFrame& run, uint64_t seed) {
  RenderRequest request = request_of(context.plan.picture, run.technique, seed);
  request.parameters = run.result.parameters;
  return request;
}

// Only where both renderers see the same.
std::vector<uint8_t> mask_of(const Image& test, const Image& reference, const Camera& camera) {
  const double eye_world[3] = {camera.eye_world.x, camera.eye_world.y, camera.eye_world.z};
  const Parity parity = compare_surfaces(test, reference, eye_world);
  if (!parity.passes)
    fail_input(fmt::format("the renderers agree on {:.2f} % only", 100.0 * parity.agreement));
  return scored_mask(parity, reference);
}

void set(Scene& stage, const Moment& moment) {
  stage.camera = moment.camera;
  stage.lights.at(stage.active_light) = moment.light;
}

/// A run's pictures of a sequence and what the metrics ask beside them.
struct Take {
  std::vector<Image> tests;
  std::vector<std::vector<uint8_t>> masks;
  std::vector<SequenceFrame> frames;
};

Take record(const SceneContext& context, const Sequence& sequence, const TechniqueFrame& run,
            const RenderRequest& request) {
  Take take;
  constexpr std::array kTestChannels = {"visibility"};
  Scene stage = context.scene;
  for (size_t k = 0; k < sequence.moments.size(); ++k) {
    set(stage, sequence.moments[k]);
    const Frame frame =
        k == 0 ? run.frame : context.renderers.realtime.render(stage, request, context.progress);
    take.masks.push_back(mask_of(frame.image, sequence.references[k], stage.camera));
    take.tests.push_back(only(frame.image, kTestChannels));
  }
  for (size_t k = 0; k < take.tests.size(); ++k) {
    take.frames.push_back({&take.tests[k], &sequence.references[k], take.masks[k],
                           clip_from_world(sequence.moments[k].camera, request.width_px, request.height_px)});
  }
  return take;
}

std::optional<double> seed_noise(const SceneContext& context, const TechniqueFrame& run,
                                 std::span<const uint8_t> mask) {
  std::vector<Image> tests;
  std::vector<const Image*> pointers = {&run.frame.image};
  for (uint64_t k = 1; k < kTemporalSeeds; ++k) {
    const RenderRequest request = request_of(context, run, context.plan.picture.seed + k);
    tests.push_back(context.renderers.realtime.render(context.scene, request, context.progress).image);
  }
  for (const Image& test : tests) pointers.push_back(&test);
  return measure_seed_noise(pointers, mask);
}

}  // namespace

Moment moment_of(const Scene& scene, Motion motion, int k, int height_px) {
  Moment moment = {scene.camera, scene.light()};
  if (motion == Motion::camera) {
    move_camera(moment.camera, k, height_px);
  } else {
    move_light(moment.light, moment.camera.at_world, k);
  }
  return moment;
}

Sequence render_sequence(const SceneContext& context, Motion motion, const Image& reference) {
  Sequence sequence;
  Scene stage = context.scene;
  const RenderRequest request = request_of(context.plan.picture);
  sequence.moments.push_back({stage.camera, stage.light()});
  sequence.references.push_back(only(reference, kReferenceChannels));
  for (int k = 1; k < context.plan.temporal_frames; ++k) {
    sequence.moments.push_back(moment_of(context.scene, motion, k, context.plan.picture.height_px));
    set(stage, sequence.moments.back());
    const Frame frame = context.renderers.reference.render(stage, request, context.progress);
    sequence.references.push_back(only(frame.image, kReferenceChannels));
  }
  return sequence;
}

void measure_temporal(const SceneContext& context, const Sequence& camera, const Sequence& light,
                      TechniqueFrame& run) {
  const RenderRequest request = request_of(context, run, context.plan.picture.seed);
  const auto failure = guarded([&] {
    TemporalNumbers numbers;
    numbers.frames = static_cast<int>(camera.moments.size());
    const Take panned = record(context, camera, run, request);
    numbers.camera = measure_flicker(panned.frames);
    numbers.light = measure_popping(record(context, light, run, request).frames);
    numbers.seed_noise = seed_noise(context, run, panned.masks.front());
    run.result.temporal = numbers;
  });
  if (failure) run.result.warnings.push_back("not measured over time: " + failure->message);
}

}  // namespace umbrameter
