// SPDX-License-Identifier: Apache-2.0
#pragma once
// A Mitsuba scene file as a tree: includes read, parameters filled in. pugixml is used by its source alone.

#include "core/error.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace umbrameter {

struct MitsubaNode {
  std::string tag;  // "shape", "float"; "lookat" and "to_world" also where 0.6 says
  std::map<std::string, std::string> attributes;  // "lookAt" and "toWorld"
  std::vector<MitsubaNode> children;
  FileLocation where;

  /// Empty when it is absent.
  const std::string& get(const std::string& attribute) const;
  /// The first child that is called `name` (its attribute); null when there is none.
  const MitsubaNode* find(const std::string& name) const;

  // Plain values by name; Error{input} at their place for anything but finite numbers and true or false.
  double number(const std::string& name, double fallback) const;
  bool boolean(const std::string& name, bool fallback) const;
  std::string text(const std::string& name, const std::string& fallback) const;
};

struct MitsubaTree {
  MitsubaNode root;                          // <scene>
  std::vector<std::filesystem::path> files;  // included, in order
};

/// Error{input} with file and line for what is no XML, a root that is not <scene>, $parameters that have no <default>, files
/// that include themselves or are not there, and files past the limits: 256 MiB each, 1,000 of them, 2,000,000 elements,
/// nested 64 deep.
MitsubaTree read_mitsuba_tree(const std::filesystem::path& path);

}  // namespace umbrameter
