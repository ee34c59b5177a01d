// SPDX-License-Identifier: Apache-2.0
#pragma once
// A study as its file says it (docs/studies.md): which scenes, which runs with which parameters, and what a paper
// claims about them. Not here: whether scenes, techniques and parameters exist (cli/), and what runs it (study/grid/bench.h).

#include "core/toml.h"
#include "results/bench/claim.h"
#include "scenes/altered/study_camera.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbrameter {

/// One point of a `[[run]]` table's grid.
struct StudyRun {
  std::string label;      // unique in the study
  std::string technique;  // or the path of a finished picture, relative to the study's folder
  bool is_picture = false;
  std::string preset;                                    // empty = the defaults
  std::vector<std::pair<std::string, TomlNode>> values;  // one value a parameter, not yet checked
  FileLocation where;
};

struct StudyFile {
  std::string title;
  std::string doc;
  std::vector<std::string> scenes;              // as written: library names or paths
  std::vector<double> times_s;                  // moments of the scenes' animations; none: as their files say
  std::string animation;                        // of those; as AnimationTime's
  std::vector<std::string> lights;              // names or numbers; none: every light of each scene
  std::vector<StudyCamera> cameras;             // every scene is seen from each; none: from its own
  std::vector<std::string> qualities{"quick"};  // each a study of its own; the next four go with one
  std::optional<int64_t> width_px, height_px, samples_per_pixel;
  std::optional<double> target_se;
  std::vector<uint64_t> seeds{1};
  int frames = 30;
  double frame_budget_s = 3.0;
  std::vector<StudyRun> runs;  // grids expanded, in file order, the last list fastest
  std::vector<Claim> claims;
  FileLocation where;
};

inline constexpr size_t kMaxStudyRuns = 4096;

/// Error{input} with file, line and hint for unknown keys, wrong types, labels that are not unique or unknown, grids
/// of more than kMaxStudyRuns runs, and claims that say nothing.
StudyFile parse_study(std::string_view document, const std::string& file);
StudyFile load_study(const std::filesystem::path& path);
/// The same of a table that is already parsed.
StudyFile read_study(const TomlNode& root);

}  // namespace umbrameter
