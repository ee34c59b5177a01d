// SPDX-License-Identifier: Apache-2.0
#pragma once
// The ray tracer, with the samples of a picture's quality.

#include "cli/verbs.h"
#include "core/renderer.h"
#include "results/picture_quality.h"

#include <memory>

namespace umbrameter {

/// Who makes truths, as keys of the store have it (lab/keys.h).
extern const char* const kReferenceMaker;

/// `skip_proven`: as in reference/reference.h.
std::unique_ptr<Renderer> open_reference_renderer(const GlobalOptions& options, const PictureQuality& picture,
                                                  bool skip_proven = true);

}  // namespace umbrameter
