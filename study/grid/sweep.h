// SPDX-License-Identifier: Apache-2.0
#pragma once
// Does what a plan says: renders, scores and stores run by run, so that a sweep killed at any moment goes on where it was.
// Frames, when they are timed, are drawn in turn with those of the scene's first run alone: what was done need not be
// alive. Sees only Renderer&.

#include "study/grid/plan.h"

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct SweepOutcome {
  size_t rendered = 0, reused = 0, skipped = 0;  // runs
  size_t references_rendered = 0;
  size_t not_done = 0;  // runs whose scene has no truth
  std::map<Comparison, size_t>
      verdicts;  // of rendered runs against the scene's first, where that one is stored
  std::vector<std::string> unmeasured;  // why runs say nothing (results/measured.h), also of reused runs
  std::vector<Failure> failures;        // "scene: ..." or "scene, run: ...", also of reused runs
};

/// Called when a run or a truth has failed.
using SweepFailed = std::function<void(const Failure&)>;

/// A run that throws is recorded in the store and the rest goes on; a truth that throws leaves its scene's runs undone.
/// What the store throws passes through. What another process has stored meanwhile is not made again. `scratch` is an
/// existing folder for files in the making.
SweepOutcome run_sweep(const SweepPlan& plan, std::span<const StudyScene> scenes,
                       std::span<const PlanStep> steps, Renderers renderers, Store& store,
                       const std::filesystem::path& scratch, Progress& progress,
                       const SweepFailed& failed = {});

}  // namespace umbrameter
