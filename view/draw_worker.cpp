// SPDX-License-Identifier: Apache-2.0
#include "view/draw_worker.h"

#include "core/clock.h"

#include <algorithm>

namespace umbrameter {
namespace {

constexpr int kTimedFrames = 5;

/// Medians over a few frames; nothing once the job is stale.
void time_passes(const PreparedRun& run, const DrawWorker::Desk& desk, Drawing& drawing) {
  if (!run.time_frame) return;
  std::vector<std::vector<double>> frames;
  while (frames.size() < kTimedFrames && !desk.is_stale()) frames.push_back(run.time_frame());
  if (frames.size() < kTimedFrames) return;
  drawing.passes = run.passes;
  drawing.timer = run.timer;
  for (size_t pass = 0; pass < run.passes.size(); ++pass) {
    std::vector<double> times_ms;
    for (const std::vector<double>& frame : frames) times_ms.push_back(frame[pass]);
    std::ranges::nth_element(times_ms, times_ms.begin() + kTimedFrames / 2);
    drawing.times_ms.push_back(times_ms[kTimedFrames / 2]);
  }
}

void draw(const DrawJob& job, Scene& scene, Renderer& renderer, DrawWorker::Desk& desk) {
  move_to(job.place, scene);
  SilentProgress progress;
  Drawing drawing;
  drawing.job = job;
  const Clock::time_point start = Clock::now();
  PreparedRun run;
  if (job.wants_times) {
    run = renderer.prepare(scene, job.request, progress);
    drawing.frame = std::move(run.frame);
    drawing.drawn = drawn_passes(renderer, scene, job.request);
  } else {
    drawing.frame = renderer.render(scene, job.request, progress);
  }
  drawing.wall_time_s = seconds_since(start);
  if (job.resource) drawing.resource = dump_resource(renderer, scene, job.request, *job.resource, progress);
  if (job.wants_maps) {
    if (auto maps = map_indices(renderer, scene, job.request))
      drawing.maps = std::make_shared<const Image>(std::move(*maps));
  }
  desk.publish(drawing);
  if (!job.wants_times) return;
  time_passes(run, desk, drawing);
  if (!drawing.passes.empty()) desk.publish(std::move(drawing));
}

}  // namespace

void move_to(const Place& place, Scene& scene) {
  scene.camera = place.camera;
  scene.lights.at(scene.active_light) = place.light;
}

DrawWorker::Work open_drawing(Scene scene, const std::function<std::unique_ptr<Renderer>()>& open_renderer) {
  struct Owned {
    Scene scene;
    std::unique_ptr<Renderer> renderer;
  };
  auto owned = std::make_shared<Owned>(Owned{std::move(scene), open_renderer()});
  return [owned](const DrawJob& job, DrawWorker::Desk& desk) {
    draw(job, owned->scene, *owned->renderer, desk);
  };
}

}  // namespace umbrameter
