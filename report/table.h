// SPDX-License-Identifier: Apache-2.0
#pragma once
// The report's summary table, as data.

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace umbrameter {

/// One object a run, failed ones included: [value, text] by column, value null where absent; `verdict` is a text, and `missing`
/// says why a run has no error.
nlohmann::ordered_json summary_rows(const SceneResult& scene);

}  // namespace umbrameter
