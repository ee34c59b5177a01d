#include "study/sweep/make_record.h"

#include "umbrameter_version.h"

namespace umbrameter {

RecordHead make_head(const StudyScene& scene, const PictureQuality& quality, uint64_t seed) {
  RecordHead head;
  head.scene = scene.name;
  head.camera = scene.camera;
  head.scene_hash = scene.scene.hash;
  head.light = to_text(scene.scene.light().type);
  head.width_px = quality.width_px;
  head.height_px = quality.height_px;
  head.samples_per_pixel = quality.samples_per_pixel;
  head.target_se = quality.target_se;
  head.seed = seed;
  head.commit = UMBRAMETER_COMMIT;
  head.started = time_now();
  return head;
}

RunRecord make_record(const BenchRun& run, RecordHead head, const std::string& reference) {
  RunRecord record;
  record.head = std::move(head);
  record.reference = reference;
  TechniqueResult& result = record.result;
  result.label = run.technique.label;
  result.technique = run.technique.id;
  result.title = run.technique.title;
  result.hash = run.technique.hash;
  result.parameters = run.technique.parameters;
  return record;
}

void take_frame(const TimedRun& run, TechniqueResult& result) {
  const Frame& frame = run.frame;
  result.parameters = frame.parameters;
  result.pass_times = summarise(run.times);
  result.timer = run.timer;
  result.device = frame.device;
  result.memory_bytes = frame.memory_bytes;
  result.wall_time_s = frame.wall_time_s;
  result.warnings = frame.warnings;
  result.left_out = frame.left_out;
}

void take_score(const Score& score, RunRecord& record) {
  record.parity = parity_numbers(score.parity, ParityTolerance{}.required_agreement);
  record.result.error = score.error;
  record.result.judgement = score.judgement;
  record.result.diagnosis = score.diagnosis;
  record.result.similarity = score.similarity;
  if (score.no_diagnosis)
    record.result.warnings.push_back("the faults could not be told apart: " + score.no_diagnosis->message);
}

}  // namespace umbrameter
