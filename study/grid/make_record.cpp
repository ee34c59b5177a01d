// SPDX-License-Identifier: Apache-2.0
#include "study/grid/make_record.h"

#include "lab/technique_result.h"

namespace umbrameter {

RecordHead make_head(const StudyScene& scene, PictureQuality picture, uint64_t seed) {
  picture.seed = seed;
  RecordHead head = make_head(scene.name, scene.scene, picture);
  head.camera = scene.camera;
  return head;
}

RunRecord make_record(const BenchRun& run, RecordHead head, const std::string& reference) {
  RunRecord record;
  record.head = std::move(head);
  record.reference = reference;
  record.result = describe(run.technique);
  return record;
}

void take_score(const Score& score, RunRecord& record) {
  record.parity = parity_numbers(score.parity, ParityTolerance{}.required_agreement);
  static_cast<Measures&>(record.result) = score;
  if (score.no_diagnosis)
    record.result.warnings.push_back("the faults could not be told apart: " + score.no_diagnosis->message);
}

}  // namespace umbrameter
