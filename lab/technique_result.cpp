// SPDX-License-Identifier: Apache-2.0
#include "lab/technique_result.h"

#include "metrics/shadow_quantity.h"

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

void take_frame(const TimedRun& run, TechniqueResult& result) {
  result.quantity = to_text(quantity_of(run.frame.image));
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

}  // namespace umbrameter
