// SPDX-License-Identifier: Apache-2.0
#pragma once
// The renderer of all runs: our techniques on GL, and engines by their folders.

#include "cli/home.h"
#include "cli/staging.h"
#include "core/renderer.h"

#include <memory>
#include <optional>
#include <string>

namespace umbrameter {

/// An engine's frame gets the surfaces of our own rasteriser, once the engine's own agree with them (metrics/image/parity.h); pixels
/// that do not agree become unknown. Error{environment} when too few do.
class RunRenderer final : public Renderer {
 public:
  RunRenderer(std::unique_ptr<Renderer> gl, EnginePlaces places)
      : gl_(std::move(gl)), places_(std::move(places)) {}

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override;
  PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) override;

  const Renderer& gl() const { return *gl_; }

 private:
  bool is_engine(const RenderRequest& request) const;
  Renderer& engines();
  void compare_with_ours(const Scene& scene, const RenderRequest& request, Frame& frame, Progress& progress);

  std::unique_ptr<Renderer> gl_;
  EnginePlaces places_;
  std::optional<Staging> work_;        // of the engines; opened with the first
  std::unique_ptr<Renderer> engines_;  // lives in work_
};

/// Of the GL device (realtime/device_identity.h); `renderer` is one of open_realtime_renderer(). An engine says in its hash
/// and in each frame what it is.
std::string run_identity(const Renderer& renderer);

}  // namespace umbrameter
