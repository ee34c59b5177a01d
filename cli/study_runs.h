// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a study file names, found: its scenes loaded, its runs resolved against the techniques' manifests.

#include "cli/home.h"
#include "cli/quality.h"
#include "study/grid/bench.h"
#include "study/study_file.h"

#include <filesystem>
#include <vector>

namespace umbrameter {

/// Scene files and technique folders are looked for beside the study first. Scenes keep the study's names; with
/// cameras each scene is there once a camera, with times once a time. Error{input} for what does not exist.
std::vector<StudyScene> load_study_scenes(const StudyFile& study, const std::filesystem::path& file,
                                          const SceneSearch& search, Progress& progress);

/// Every run with every seed. Error{input} at its place for unknown parameters and values out of range.
std::vector<BenchRun> choose_study_runs(const StudyFile& study, const std::filesystem::path& file,
                                        const Home& home);

/// The study's qualities with its own numbers, and those of `given` (its name and seed aside) above them. Error{input} for
/// `given` numbers and several qualities.
std::vector<Quality> choose_study_qualities(const StudyFile& study, const QualityOptions& given);

/// "quick, 480 x 270 px, 256 samples", above what is printed of one of several.
std::string quality_heading(const Quality& quality);

}  // namespace umbrameter
