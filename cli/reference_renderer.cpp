// SPDX-License-Identifier: Apache-2.0
#include "cli/reference_renderer.h"

#include "reference/reference.h"

namespace umbrameter {

const char* const kReferenceMaker = "Embree " UMBRAMETER_EMBREE_VERSION;

std::unique_ptr<Renderer> open_reference_renderer(const GlobalOptions& options, const PictureQuality& picture,
                                                  bool skip_proven) {
  return make_reference_renderer({.samples_per_pixel = picture.samples_per_pixel,
                                  .target_se = picture.target_se,
                                  .threads = options.threads,
                                  .skip_proven = skip_proven});
}

}  // namespace umbrameter
