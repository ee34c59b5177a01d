// SPDX-License-Identifier: Apache-2.0
// Renders the truth of an installed scene and scores it against itself: 0 but for its noise.
#include "lab/score.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"

#include <cstdio>

int main() {
  using namespace umbrameter;
  const std::filesystem::path library = std::filesystem::path(DATA_FOLDER) / "scenes" / "library";
  const Scene scene = load_scene(library / "plate.toml", {{}, library});
  SilentProgress progress;
  const RenderRequest request{.width_px = 64, .height_px = 36, .seed = 1, .technique = {}, .parameters = {}};
  const Frame truth = make_reference_renderer({.samples_per_pixel = 64, .target_se = {}, .threads = 1})
                          ->render(scene, request, progress);
  const Score score = score_image(truth.image, truth.image, scene.camera.eye_world);
  if (!score.error || !score.error->bias) return 1;
  std::printf("plate: %zu px scored, bias %.6f\n", score.error->scored_pixels, *score.error->bias);
  return score.error->scored_pixels > 1000 && *score.error->bias == 0.0 ? 0 : 1;
}
