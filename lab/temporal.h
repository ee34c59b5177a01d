// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sequences for the temporal metrics: the camera or the light moves, or the seed changes. Not here: the metrics
// (metrics/temporal/temporal.h) and the steps (scenes/motion.h).

#include "metrics/temporal/temporal.h"
#include "results/results.h"
#include "scenes/scene.h"

#include <string_view>
#include <vector>

namespace umbrameter {

struct SceneContext;    // lab/scene_run.h
struct TechniqueFrame;  // lab/scene_run.h

/// A motion (scenes/motion.h) forward from the scene, which is frame 0, with the truth of each frame.
struct Sequence {
  std::vector<Scene> scenes;
  std::vector<Image> references;  // only the channels that the metrics need
};

/// Renders the truth of the plan's temporal_frames of standard_motion() `motion`; `reference` is that of frame 0.
Sequence render_sequence(const SceneContext& context, std::string_view motion, const Image& reference);

/// Renders the run in both sequences and with three seeds, and sets its `temporal`, or warns why not.
void measure_temporal(const SceneContext& context, const Sequence& camera, const Sequence& light,
                      TechniqueFrame& run);

}  // namespace umbrameter
