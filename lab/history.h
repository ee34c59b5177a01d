// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rows of the catalogue that ask how a technique with history gets to its picture. Not here: the metrics
// (metrics/temporal/history.h).

#include "core/image.h"

namespace umbrameter {

struct SceneContext;    // lab/scene_run.h
struct TechniqueFrame;  // lab/scene_run.h

/// Renders a scored run again where nothing moves, after 1, 2, 4, ... frames and after as many as its own picture, and measures
/// its rows anew with them; warns why not. Does nothing for a run without history.
void measure_history(const SceneContext& context, const Image& reference, TechniqueFrame& run);

}  // namespace umbrameter
