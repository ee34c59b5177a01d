// SPDX-License-Identifier: Apache-2.0
#pragma once
// Techniques drawn on a thread of their own, which owns the GL renderer.

#include "core/renderer.h"
#include "realtime/inspect.h"
#include "scenes/scene.h"
#include "view/latest_worker.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Where the light and the eye are; what a truth depends on, beside the size of the picture.
struct Place {
  Camera camera;
  Light light;
  int width_px = 0, height_px = 0;
  uint64_t version = 0;  // two of the same version are equal
};

/// `scene` lit and seen as `place` says.
void move_to(const Place& place, Scene& scene);

struct DrawJob {
  Place place;
  RenderRequest request;     // its size may be less than the place's
  uint64_t run_version = 0;  // of technique, parameters and shader files
  bool wants_times = false;  // of each pass, over a few frames
  bool wants_maps = false;   // which map each pixel is looked up in
  std::optional<ResourcePart> resource;
};

struct Drawing {
  DrawJob job;
  Frame frame;
  double wall_time_s = 0.0;
  std::vector<std::string> passes;  // with times_ms: the medians; empty when not asked for
  std::vector<double> times_ms;
  std::string timer;
  std::vector<std::string> drawn;  // ids of the manifest's passes, with wants_times
  std::optional<Image> resource;
  std::shared_ptr<const Image> maps;  // of realtime/inspect.h's map_indices(); null with less than two maps
};

using DrawWorker = LatestWorker<DrawJob, Drawing>;

/// What a DrawWorker opens. `open_renderer` makes a real-time renderer (realtime/realtime.h), on the worker's thread.
DrawWorker::Work open_drawing(Scene scene, const std::function<std::unique_ptr<Renderer>()>& open_renderer);

}  // namespace umbrameter
