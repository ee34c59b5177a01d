// SPDX-License-Identifier: Apache-2.0
#pragma once
// The halves of `techniques` that render or read results.

#include "cli/verbs.h"

#include <string>
#include <vector>

namespace umbrameter {

/// `techniques traits [ID...]`: none = all.
int show_traits(const std::vector<std::string>& ids, const GlobalOptions& global);

/// `techniques doc RESULTS`: docs/techniques.md from the manifests and a validation's results.json.
int write_technique_doc(const std::string& results_file, const GlobalOptions& global);

}  // namespace umbrameter
