// SPDX-License-Identifier: Apache-2.0
#pragma once
// From technique.toml to a Technique: keys, types and expressions, each checked where it stands. What needs
// the whole picture is in check_technique.h.

#include "realtime/manifest/technique.h"

#include <set>
#include <string>
#include <vector>

namespace umbrameter {

/// A Technique (without its hash) and what its checks need to know.
struct Manifest {
  Technique technique;
  std::set<std::string, std::less<>> expression_names;  // every name that an expression, or a fit, uses
  std::vector<std::filesystem::path> files;             // the manifest and what it includes
};

Manifest read_manifest(const std::filesystem::path& folder, const std::filesystem::path& shared_folder);

}  // namespace umbrameter
