// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the page says of the results in words, as data: the same texts as the terminal's.

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace umbrameter {

/// {context, summary, scenes: [{parity, common, reference, rows, runs}], skipped, pixel_steps}. Facts are lists of [term, text];
/// `parity` and `reference` are null where there is none.
nlohmann::ordered_json page_texts(const Results& results);

}  // namespace umbrameter
