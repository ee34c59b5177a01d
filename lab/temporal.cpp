// SPDX-License-Identifier: Apache-2.0
#include "lab/temporal.h"

#include "core/error.h"
#include "core/guard.h"
#include "lab/scene_run.h"

#include <array>

namespace umbrameter {
namespace {

constexpr int kTemporalSeeds = 3;

constexpr std::array kReferenceChannels = {
    "half_a",   "half_b",   "position.x", "position.y",   "position.z",
    "normal.x", "normal.y", "normal.z",   "primitive_id", "unshadowed_irradiance"};

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
  const glm::dvec3& eye_world = camera.eye_world;
  const Parity parity = compare_surfaces(test, reference, eye_world);
  if (!parity.passes)
    fail_input(fmt::format("the renderers agree on {:.2f} % only", 100.0 * parity.agreement));
  return scored_mask(parity, reference);
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
  const bool stands_still = run.result.frames_before == 0;  // frame 0 is the same whatever moves
  for (size_t k = 0; k < sequence.scenes.size(); ++k) {
    const Scene& stage = sequence.scenes[k];
    const Frame frame = k == 0 && stands_still
                            ? run.frame
                            : context.renderers.realtime.render(stage, request, context.progress);
    take.masks.push_back(mask_of(frame.image, sequence.references[k], stage.camera));
    take.tests.push_back(only(frame.image, kTestChannels));
  }
  for (size_t k = 0; k < take.tests.size(); ++k) {
    take.frames.push_back({&take.tests[k], &sequence.references[k], take.masks[k],
                           clip_from_world(sequence.scenes[k].camera, request.width_px, request.height_px)});
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

Sequence render_sequence(const SceneContext& context, std::string_view motion, const Image& reference) {
  Sequence sequence;
  Scene stage = context.scene;
  stage.motion = standard_motion(motion, stage);
  const RenderRequest request = request_of(context.plan.picture);
  sequence.scenes.push_back(stage);
  sequence.references.push_back(only(reference, kReferenceChannels));
  for (int k = 1; k < context.plan.temporal_frames; ++k) {
    sequence.scenes.push_back(scene_at(stage, k, request.height_px));
    const Frame frame = context.renderers.reference.render(sequence.scenes.back(), request, context.progress);
    sequence.references.push_back(only(frame.image, kReferenceChannels));
  }
  return sequence;
}

void measure_temporal(const SceneContext& context, const Sequence& camera, const Sequence& light,
                      TechniqueFrame& run) {
  const RenderRequest request = request_of(context, run, context.plan.picture.seed);
  const auto failure = guarded([&] {
    TemporalNumbers numbers;
    numbers.frames = static_cast<int>(camera.scenes.size());
    const Take panned = record(context, camera, run, request);
    numbers.camera = measure_flicker(panned.frames);
    numbers.light = measure_popping(record(context, light, run, request).frames);
    numbers.seed_noise = seed_noise(context, run, panned.masks.front());
    run.result.temporal = numbers;
  });
  if (failure) run.result.warnings.push_back("not measured over time: " + failure->message);
}

}  // namespace umbrameter
