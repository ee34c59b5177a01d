// SPDX-License-Identifier: Apache-2.0
#include "lab/history.h"

#include "core/guard.h"
#include "lab/scene_run.h"
#include "results/catalogue.h"

#include <vector>

namespace umbrameter {
namespace {

/// 1, 2, 4, ..., and `last`.
std::vector<int> frames_up_to(int last) {
  std::vector<int> frames;
  for (int n = 1; n < last; n *= 2) frames.push_back(n);
  frames.push_back(last);
  return frames;
}

Image render_still(const SceneContext& context, const TechniqueFrame& run, int frames) {
  Scene stage = context.scene;
  stage.motion = {};
  stage.motion.frames_before = frames - 1;
  RenderRequest request = request_of(context.plan.picture, run.technique, context.plan.picture.seed);
  request.parameters = run.result.parameters;
  return context.renderers.realtime.render(stage, request, context.progress).image;
}

}  // namespace

void measure_history(const SceneContext& context, const Image& reference, TechniqueFrame& run) {
  const int last = run.result.frames_before + 1;
  if (last == 1) return;
  const auto failure = guarded([&] {
    std::vector<Image> images;
    const std::vector<int> frames = frames_up_to(last);
    for (const int n : frames) images.push_back(render_still(context, run, n));
    std::vector<StillPicture> pictures;
    for (size_t i = 0; i < frames.size(); ++i) pictures.push_back({frames[i], &images[i]});
    const bool has_moved = run.result.motion != Motion{}.name;
    const auto values =
        measure_rows({run.frame.image, reference, run.mask, has_moved ? &images.back() : nullptr, pictures});
    for (const auto& [key, value] : values) run.result.measured[key] = value;
  });
  if (failure) run.result.warnings.push_back("not measured over frames: " + failure->message);
}

}  // namespace umbrameter
