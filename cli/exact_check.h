// SPDX-License-Identifier: Apache-2.0
#pragma once
// `reference --exact-check`: drawing the points, asking the oracle, saying what came out.

#include "cli/quality.h"
#include "core/renderer.h"
#include "reference/exact_check.h"

#include <nlohmann/json_fwd.hpp>

namespace umbrameter {

struct ExactCheck {
  std::vector<CheckedPoint> points;
  ExactComparison comparison;
  double cpu_time_s = 0.0;  // of the oracle, a process that has ended
};

/// Compares `reference`, rendered to `request`, with `oracle` at `count` of its pixels.
ExactCheck run_exact_check(const Scene& scene, const Image& reference, const RenderRequest& request,
                           size_t count, const ExactOracle& oracle, int threads, Progress& progress);

std::string describe(const ExactCheck& check);
nlohmann::json to_json(const ExactCheck& check);

}  // namespace umbrameter
