// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long a run or a truth will take: from what the store has seen, else a rough model.

#include "lab/keys.h"
#include "lab/timing.h"
#include "store/store.h"

#include <map>
#include <string>
#include <vector>

namespace umbrameter {

/// Seconds of stored results.
struct Costs {
  std::map<std::string, std::vector<double>> run_s_per_pixel;    // by technique
  std::map<std::string, std::vector<double>> frame_s_per_pixel;  // likewise, of runs with times
  std::vector<double> reference_s_per_sample;
};

struct Estimate {
  double seconds = 0.0;
  size_t like = 0;  // stored results that this is the median of; 0 = the rough model
};

// The rough model, of a slow machine: two cores, GL in software.
inline constexpr double kRoughRun_s = 0.3;             // compiling
inline constexpr double kRoughRun_s_per_pixel = 4e-6;  // rendering and scoring
inline constexpr double kRoughFrame_s_per_pixel = 1e-7;
inline constexpr double kRoughReference_s_per_sample = 2e-7;

/// Of the newest runs and truths that did not fail. `store` may be null.
Costs costs_of(Store* store);

/// With `timing` also its frames, drawn in turn with as many of another run.
Estimate estimate_run(const Costs& costs, const std::string& technique, const PictureQuality& quality,
                      const std::optional<TimingPlan>& timing = {});
Estimate estimate_reference(const Costs& costs, const PictureQuality& quality);

}  // namespace umbrameter
