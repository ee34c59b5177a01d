// SPDX-License-Identifier: Apache-2.0
#pragma once
// A renderer that is opened when something is rendered: no GL context and no Embree device for what is known already.

#include "core/renderer.h"

#include <functional>
#include <memory>

namespace umbrameter {

class LazyRenderer final : public Renderer {
 public:
  explicit LazyRenderer(std::function<std::unique_ptr<Renderer>()> open) : open_(std::move(open)) {}

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    return renderer().render(scene, request, progress);
  }
  PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    return renderer().prepare(scene, request, progress);
  }

  /// Opened when it is not yet.
  Renderer& renderer() {
    if (!renderer_) renderer_ = open_();
    return *renderer_;
  }

 private:
  std::function<std::unique_ptr<Renderer>()> open_;
  std::unique_ptr<Renderer> renderer_;
};

}  // namespace umbrameter
