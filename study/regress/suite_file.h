// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a regression suite's file says (docs/regress.md): scenes and runs as a study says them, and the gates they must
// keep. Not here: whether scenes and techniques exist (cli/).

#include "results/catalogue.h"
#include "study/study_file.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace umbrameter {

struct RegressGates {
  GateLimits worse_by = gate_limits();  // than the baseline, by kind of fault and by metric
  std::map<std::string, double>
      at_most;  // by measure (results/regress/case_numbers.h), whatever the baseline says
  bool ratchet = true;
  double same_share = 0.05;          // ratchet: mean squared errors this close are the same
  double same_rmse = 1e-3;           // likewise; what rounding on another device may change
  double sigmas = 4.0;               // of noise, beyond which a difference is certain
  std::optional<double> time_ratio;  // frame time over the baseline's; absent: not judged
};

struct RegressSuite {
  StudyFile study;
  int most_samples_per_pixel =
      0;  // what undecided cases may get, and baselines are made with; 0 = 4 x the study's
  RegressGates gates;
};

/// Error{input} with file, line and hint, as for studies.
RegressSuite parse_suite(std::string_view document, const std::string& file);
RegressSuite load_suite(const std::filesystem::path& path);

}  // namespace umbrameter
