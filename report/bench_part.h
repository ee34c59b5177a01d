// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `bench` measured: time against error of a study's runs, the front, the truth's own curve, and papers' claims.

#include "report/side_files.h"

namespace umbrameter {

/// A part of the page that another verb's files give.
struct SidePart {
  std::string html;                                                // empty without such files
  nlohmann::ordered_json plots = nlohmann::ordered_json::array();  // for the page's scripts
};

/// Of every bench*.json in `folder`, as 'bench --json' prints it (docs/studies.md). `plots`: one a scene and study, for the
/// figures #bench-1, #bench-2, ...: {runs: [{label, time_ms, rmse, is_on_front}], recommended, note, truth}. Error{input}
/// naming the file when one is malformed.
SidePart bench_part(const std::filesystem::path& folder);

}  // namespace umbrameter
