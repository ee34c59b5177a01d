// SPDX-License-Identifier: Apache-2.0
#pragma once
// A difficulty axis: a family of scenes or parameters that one number, or one word, makes harder (docs/stability.md).
// Not here: what comes of it (study/stress/run.h).

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

/// A place on an axis. Axes of words leave `number` at 0.
struct StressValue {
  std::string text;
  double number = 0.0;
};

/// Text in technique manifests, replaced wherever it stands: what no parameter can change, as a format.
struct ManifestEdit {
  std::string from, to;
};

/// What to do at a value: a scene as a file would say it, and parameters.
struct StressPoint {
  std::string scene;                                       // TOML
  std::vector<std::pair<std::string, std::string>> files;  // that the scene names: file name, bytes
  std::vector<std::string> assignments;  // "name=value"; each for the techniques that have the parameter
  std::vector<ManifestEdit> edits;
  size_t active_light = 0;       // of the file's lights, the one that is drawn
  bool must_be_refused = false;  // the scene is no scene; a picture of it would be a lie
};

struct StressAxis {
  std::string name, unit, doc;
  std::vector<StressValue> values;  // in order; harder the further from the nominal one
  size_t nominal = 0;
  /// Techniques without any of these parameters are not concerned; empty: all are.
  std::vector<std::string> needs_parameter;
  std::function<StressPoint(const StressValue&)> point;
};

/// Values as {:g} writes them.
std::vector<StressValue> numbers(const std::vector<double>& values);
std::vector<StressValue> words(const std::vector<std::string>& values);

}  // namespace umbrameter
