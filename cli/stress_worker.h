// SPDX-License-Identifier: Apache-2.0
#pragma once
// One axis of a stress run in a process of its own, and the process that looks after it.

#include "cli/verbs.h"
#include "study/stress/kept_cells.h"
#include "study/stress/run.h"

#include <filesystem>

namespace umbrameter {

/// The techniques that the plan names, all built-in ones without a name. Error{input} for an unknown one, and for settings.
std::vector<TechniqueRun> stress_techniques(const StressPlan& plan);

/// Where an axis keeps its journal, scenes and pictures.
std::filesystem::path axis_folder(const std::filesystem::path& folder, const StressAxis& axis);

/// The worker's side: does what the axis's journal lacks. Truths are those of the store in --out, if `reuse` may be.
void work_on_axis(const StressAxis& axis, const StressPlan& plan, const GlobalOptions& global,
                  const std::filesystem::path& folder, bool keep_pictures, bool reuse);

/// The other side: starts workers with `arguments` until every cell of the axis is there; what ends a worker becomes a
/// cell. What `answers` knows is not walked again, and they learn the rest as it comes. Error{internal} when workers end before
/// they start anything.
std::vector<StressCell> watch_axis(const StressAxis& axis, const StressPlan& plan, const StressKeys& keys,
                                   Answers& answers, const std::vector<std::string>& arguments,
                                   const std::filesystem::path& folder, Progress& progress);

}  // namespace umbrameter
