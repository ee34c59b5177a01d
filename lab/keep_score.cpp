// SPDX-License-Identifier: Apache-2.0
#include "lab/keep_score.h"

#include "core/clock.h"
#include "lab/stored_truth.h"
#include "metrics/image/shadow_quantity.h"
#include "results/pictures/pictures.h"

namespace umbrameter {
namespace {

std::string keep_picture(const Keeper& keeper, const Picture& picture) {
  const std::filesystem::path file = keeper.scratch / "picture.png";
  write_picture(file, picture);
  return keeper.store.keep(file);
}

/// As a validation keeps it. An engine's surfaces are not those of our G-buffer.
void require_parity(const Keeper& keeper, const Parity& parity, const Image& image,
                    const std::string& reference) {
  const std::string key = parity_key(reference, keeper.makers);
  if (image.metadata.contains("engine_parity") || keeper.store.find(key)) return;
  ParityNumbers numbers = parity_numbers(parity);
  numbers.picture_file = keep_picture(keeper, parity_picture(parity));
  keep_parity(keeper.store, key, numbers);
}

void take_score(const Score& score, RunRecord& record) {
  record.parity = parity_numbers(score.parity);
  static_cast<Measures&>(record.result) = score;
  if (score.no_diagnosis)
    record.result.warnings.push_back("the faults could not be told apart: " + score.no_diagnosis->message);
}

}  // namespace

KeptScore keep_score(const Keeper& keeper, const Scene& scene, const Image& picture, const Image& truth,
                     MetricChoice metrics, SharedTruth& shared, RunRecord& record) {
  const Clock::time_point start = Clock::now();
  metrics.verdict = false;  // a verdict is of two runs
  std::optional<Image> made;
  const Image& asked = truth_for(picture, truth, made);
  Score score = score_image(picture, asked, scene.camera.eye_world, {metrics, {}}, made ? nullptr : &shared);
  take_score(score, record);
  require_parity(keeper, score.parity, picture, record.reference);
  TechniqueResult& result = record.result;
  if (score.diagnosis)
    result.fault_picture_file =
        keep_picture(keeper, fault_picture(score.fault_classes, asked.width, asked.height));
  KeptScore kept{{picture_to_store(picture, score.mask), std::move(score.mask)}, score.scorable_pixels};
  result.image_file = keep_image(keeper.store, kept.picture.image, keeper.scratch);
  record.head.duration_s = result.wall_time_s + seconds_since(start);
  return kept;
}

}  // namespace umbrameter
