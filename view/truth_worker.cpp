// SPDX-License-Identifier: Apache-2.0
#include "view/truth_worker.h"

#include "core/clock.h"
#include "metrics/image/parity.h"
#include "reference/reference.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// Earlier passes are thrown away: the points of a later one contain theirs, so that their mean would be no better.
std::vector<ReferenceSettings> passes(int threads) {
  std::vector<ReferenceSettings> list;
  list.push_back({.samples_per_pixel = 8, .target_se = {}, .threads = threads, .probe_blockers = false});
  list.push_back({.samples_per_pixel = 2048, .target_se = 0.02, .threads = threads});
  list.push_back({.samples_per_pixel = 8192, .target_se = 0.005, .threads = threads});
  return list;
}

void add_errors(const Image& image, TruthPass& pass) {
  const std::vector<uint8_t> mask = scorable_mask(image);
  const auto se = image.plane("visibility_se");
  double squares = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    const auto one = static_cast<double>(se[i]);
    pass.se_max = std::max(pass.se_max, one);
    squares += one * one;
    ++count;
  }
  if (count > 0) pass.se_rms = std::sqrt(squares / static_cast<double>(count));
}

struct Owned {
  std::vector<ReferenceSettings> settings;
  Scene scene;
  std::vector<std::unique_ptr<Renderer>> renderers;  // one a pass
};

void refine(const Place& place, Owned& owned, TruthWorker::Desk& desk) {
  move_to(place, owned.scene);
  const RenderRequest request{
      .width_px = place.width_px, .height_px = place.height_px, .technique = {}, .parameters = {}};
  StaleProgress progress(desk);
  const Clock::time_point start = Clock::now();
  for (size_t i = 0; i < owned.renderers.size(); ++i) {
    Frame frame = owned.renderers[i]->render(owned.scene, request, progress);
    TruthPass pass;
    pass.place = place;
    pass.pass = static_cast<int>(i);
    pass.passes = static_cast<int>(owned.renderers.size());
    pass.promised_se = owned.settings[i].target_se.value_or(1.0);
    add_errors(frame.image, pass);
    pass.wall_time_s = seconds_since(start);
    pass.image = std::make_shared<const Image>(std::move(frame.image));
    desk.publish(std::move(pass));
  }
}

}  // namespace

TruthWorker::Work open_truth(Scene scene, int threads) {
  const std::vector<ReferenceSettings> settings = passes(threads);
  const auto owned =
      std::make_shared<Owned>(Owned{settings, std::move(scene), make_reference_renderers(settings)});
  return [owned](const Place& place, TruthWorker::Desk& desk) { refine(place, *owned, desk); };
}

}  // namespace umbrameter
