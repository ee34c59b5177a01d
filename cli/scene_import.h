// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scene files from other programs' files.

#include "cli/verbs.h"

#include <string>

namespace umbrameter {

/// Writes a scene file that refers to another program's file `name`, with its cameras and lights, to be edited.
int import_scene(const std::string& name, const GlobalOptions& global);

}  // namespace umbrameter
