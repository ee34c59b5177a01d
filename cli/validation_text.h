// SPDX-License-Identifier: Apache-2.0
#pragma once
// Results as text for the terminal.

#include "results/results.h"

#include <string>

namespace umbrameter {

/// One line when a scene is done.
std::string scene_line(const SceneResult& scene);

/// What was rendered and what was reused.
std::string work_line(const WorkDone& work);

/// The context, a table of scene x technique, limits, verdicts that more samples would decide, behaviour over time, warnings and
/// what was skipped; with details also parity, every run's significance and verdict, and the passes that were not needed.
std::string validation_text(const Results& results, bool with_details);

}  // namespace umbrameter
