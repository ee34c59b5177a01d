// SPDX-License-Identifier: Apache-2.0
#pragma once
// The halves of `techniques` that render or read results, and what `engines` shares with it.

#include "cli/home.h"
#include "cli/verbs.h"
#include "study/traits/traits.h"

#include <map>
#include <string>
#include <vector>

namespace umbrameter {

struct TraitsOptions {
  std::vector<std::string> ids;  // none = all
  PictureQuality picture = kTraitPicture;
  bool no_reuse = false;
};

/// `techniques traits [ID...]`.
int show_traits(const TraitsOptions& options, const GlobalOptions& global);

/// `techniques doc RESULTS`: docs/techniques.md from the manifests and a validation's results.json.
int write_technique_doc(const std::string& results_file, const GlobalOptions& global);

/// `techniques show ID` and `engines show ID`.
int show_technique(const std::string& id, const GlobalOptions& global);

/// `techniques glsl ID`: every shader for one scene of each light type that needs another text, printed, or with --out DIR as
/// a file each. SPIR-V, which is no text, needs the folder.
int show_shaders(const std::string& technique, const std::string& language, const GlobalOptions& global);

/// One built-in scene for each light type, by type.
std::map<LightType, SceneJob> scenes_by_light(const SceneSearch& search);

}  // namespace umbrameter
