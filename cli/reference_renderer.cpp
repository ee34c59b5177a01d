// SPDX-License-Identifier: Apache-2.0
#include "cli/reference_renderer.h"

#include "cli/draw_log.h"
#include "reference/reference.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace umbrameter {
namespace {

/// The ray tracer, whose truths are in the log of what was drawn.
class LoggedReference final : public Renderer {
 public:
  LoggedReference(std::unique_ptr<Renderer> tracer, std::string settings)
      : tracer_(std::move(tracer)), settings_(std::move(settings)) {}

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    log_drawn("truth", scene, request, settings_);
    return tracer_->render(scene, request, progress);
  }

 private:
  std::unique_ptr<Renderer> tracer_;
  std::string settings_;
};

}  // namespace

const char* const kReferenceMaker = "Embree " UMBRAMETER_EMBREE_VERSION;

std::unique_ptr<Renderer> open_reference_renderer(const GlobalOptions& options, const PictureQuality& picture,
                                                  bool skip_proven) {
  const ReferenceSettings settings{.samples_per_pixel = picture.samples_per_pixel,
                                   .target_se = picture.target_se,
                                   .threads = options.threads,
                                   .skip_proven = skip_proven};
  return std::make_unique<LoggedReference>(
      make_reference_renderer(settings),
      fmt::format(":{}:{}", picture.samples_per_pixel, picture.target_se.value_or(0.0)));
}

}  // namespace umbrameter
