// SPDX-License-Identifier: Apache-2.0
#pragma once
// The text that a regression compares with: numbers with their noise, what they are of, and why they were accepted. Small
// and sorted, to be read in a diff. Not here: how numbers come about (study/regress/run.h).

#include "metrics/error/truth_numbers.h"
#include "results/regress/case_numbers.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

struct BaselineTime {
  double median_ms = 0.0;
  double mad_ms = 0.0;
  int frames = 0;
};

struct BaselineRun {
  std::string label;  // unique in its scene
  std::string technique;
  std::string hash;        // of the technique's manifest and shaders
  std::string parameters;  // complete, as one text
  std::string device;
  CaseNumbers numbers;
  std::optional<BaselineTime> time;  // of a whole frame, where the suite judges it
};

struct BaselineScene {
  std::string name;
  std::string hash;
  TruthNumbers truth;
  std::vector<BaselineRun> runs;  // by label

  const BaselineRun* find(const std::string& label) const;
};

/// Why numbers were accepted; the last one on top of those before.
struct BaselineReason {
  std::string date;  // yyyy-mm-dd
  std::string text;
  std::string version;
  std::vector<std::string> changed;  // "scene, label"; empty: everything
};

struct Baseline {
  std::string suite;
  int width_px = 0;
  int height_px = 0;
  std::vector<BaselineReason> reasons;
  std::vector<BaselineScene> scenes;  // by name

  const BaselineScene* find(const std::string& scene) const;
};

/// Adds or replaces one run of a scene, keeping the order. The scene must be there.
void put_run(BaselineScene& scene, BaselineRun run);

/// TOML; equal baselines give equal bytes, numbers have six digits.
std::string to_toml_text(const Baseline& baseline);

/// Error{input} with file, line and hint.
Baseline parse_baseline(std::string_view document, const std::string& file);
Baseline load_baseline(const std::filesystem::path& path);

}  // namespace umbrameter
