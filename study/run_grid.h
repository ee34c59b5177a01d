// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[run.values]` and `[run.sample]`: lists become a grid of runs, samples multiply it, and the label says which point of
// it a run is.

#include "study/study_file.h"

#include <string>
#include <vector>

namespace umbrameter {

/// The runs of one `[[run]]` table. Lists multiply; "{name}" in the label becomes the value, and lists and samples that the label
/// does not name are appended as "name=value".
std::vector<StudyRun> expand_run(const TomlNode& table);

}  // namespace umbrameter
