// SPDX-License-Identifier: Apache-2.0
#include "lab/technique_result.h"

#include "metrics/image/shadow_quantity.h"

#include <utility>

namespace umbrameter {

TechniqueResult describe(const TechniqueRun& run) {
  TechniqueResult result;
  result.label = run.label;
  result.technique = run.id;
  result.title = run.title;
  result.hash = run.hash;
  result.parameters = run.parameters;
  return result;
}

RunRecord make_record(const TechniqueRun& run, RecordHead head, const std::string& reference) {
  RunRecord record;
  record.head = std::move(head);
  record.reference = reference;
  record.result = describe(run);
  return record;
}

void take_frame(const Frame& frame, TechniqueResult& result) {
  result.quantity = to_text(quantity_of(frame.image));
  result.parameters = frame.parameters;
  result.device = frame.device;
  result.memory_bytes = frame.memory_bytes;
  result.wall_time_s = frame.wall_time_s;
  result.warnings = frame.warnings;
  result.left_out = frame.left_out;
  result.frames_before = frame.frames_before;
  result.motion = frame.motion;
}

void take_times(const TimedRun& run, TechniqueResult& result) {
  result.pass_times = summarise(run.times);
  result.timer = run.timer;
}

}  // namespace umbrameter
