// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene in a form that other engines read (docs/your-engine.md).

#include "cli/quality.h"
#include "cli/verbs.h"

#include <string>

namespace umbrameter {

/// Writes scene.obj and scene.json into global.out; prints what it wrote.
int export_scene(const std::string& name, const QualityOptions& size, const GlobalOptions& global);

}  // namespace umbrameter
