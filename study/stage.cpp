// SPDX-License-Identifier: Apache-2.0
#include "study/stage.h"

#include <utility>

namespace umbrameter {

PictureQuality quality_of(const SelftestSettings& settings, const SelftestRound& round) {
  return {.width_px = round.width_px,
          .height_px = round.height_px,
          .samples_per_pixel = settings.samples_per_pixel,
          .seed = round.seed};
}

Stage::Stage(SceneJob job, const SelftestSettings& settings, const SelftestRound& round,
             PictureRenderers renderers, Progress& progress)
    : ScenePictures(std::move(job), quality_of(settings, round), renderers, progress),
      settings_(settings),
      round_(round) {}

}  // namespace umbrameter
