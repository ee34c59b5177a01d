// SPDX-License-Identifier: Apache-2.0
#pragma once
// A bench's results as text for the terminal.

#include "results/bench/bench_json.h"

#include <string>

namespace umbrameter {

/// One line when a scene is done.
std::string scene_line(const BenchScene& scene);

/// The context, tables of runs (with `with_passes` also of their passes) and claims, answers to `queries`, warnings.
std::string bench_text(const BenchResults& results, const BenchQueries& queries, bool with_passes);

}  // namespace umbrameter
