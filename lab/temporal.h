// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sequences for the temporal metrics: the camera or the light moves by irrational steps, so that no texel snaps
// onto itself, or the seed changes. Not here: the metrics (metrics/temporal.h).

#include "metrics/temporal.h"
#include "results/results.h"
#include "scenes/scene.h"

#include <optional>
#include <vector>

namespace umbrameter {

struct SceneContext;    // lab/scene_run.h
struct TechniqueFrame;  // lab/scene_run.h

enum class Motion { camera, light };

/// What differs from frame to frame.
struct Moment {
  Camera camera;
  Light light;
};

/// The moments of a scene with their truth; frame 0 is the scene itself.
struct Sequence {
  std::vector<Moment> moments;
  std::vector<Image> references;  // only the channels that the metrics need
};

/// Step `k` of a sequence of pictures `height_px` high: the camera moves 3.6 px aside and 1.4 px up
/// a step, measured at what it looks at; a light 0.6 % of its distance from there along its tangent, the sun
/// 0.35 degrees.
Moment moment_of(const Scene& scene, Motion motion, int k, int height_px);

/// Renders the truth of the plan's temporal_frames; `reference` is that of frame 0.
Sequence render_sequence(const SceneContext& context, Motion motion, const Image& reference);

/// Renders the run in both sequences and with three seeds, and sets its `temporal`, or warns why not.
void measure_temporal(const SceneContext& context, const Sequence& camera, const Sequence& light,
                      TechniqueFrame& run);

}  // namespace umbrameter
