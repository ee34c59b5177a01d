// SPDX-License-Identifier: Apache-2.0
#pragma once
// Renderers that return pictures with a known error, so that a study can be checked without GL or Embree.

#include "lab/validation.h"

#include <functional>
#include <string>
#include <vector>

namespace umbrameter {

inline constexpr int kFakeWidth_px = 40;
inline constexpr int kFakeHeight_px = 30;

/// All surface channels of a flat floor; column 0 is background.
Image floor_image();

/// floor_image with everything the reference offers; visibility is 0.5 everywhere, without noise.
Image reference_image();

/// reference_image with a hard shadow of one far blocker in columns 1 to 24, full light elsewhere.
Image shadowed_reference_image();

/// shadowed_reference_image's surfaces and visibility, but for a lit slit of 3 x 20 px in the shadow.
Image leaking_image();

/// reference_image's surfaces with visibility 0.5 + `error` in the left half (columns 1 to 19), 0.5
/// elsewhere.
Image technique_image(float error);

class FakeRenderer final : public Renderer {
 public:
  using Render = std::function<Frame(const RenderRequest&)>;
  explicit FakeRenderer(Render render) : render_(std::move(render)) {}
  Frame render(const Scene&, const RenderRequest& request, Progress&) override {
    requests.push_back(request);
    return render_(request);
  }
  PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) override;

  std::vector<RenderRequest> requests;
  /// Ms of the passes "map" and "resolve" of a request's frame, counted from 0; absent: nothing is timed.
  std::function<std::vector<double>(const RenderRequest&, int frame)> time_frame;

 private:
  Render render_;
};

Frame frame_of(Image image);

/// Truth without noise.
FakeRenderer fake_reference();

/// "off": wrong by +0.1 in the left half; "broken": throws Error{input}; anything else: exact. Frames take
/// `frame_ms`.
FakeRenderer fake_realtime(double frame_ms = 1.0);

/// A scene with one rect light; nothing looks at its geometry.
SceneJob fake_scene(const std::string& name);

TechniqueRun fake_technique(const std::string& id, std::vector<LightType> lights = {LightType::rect});

ValidationPlan fake_plan(std::vector<TechniqueRun> techniques);

/// Results of run_validation over the scene "plate" with techniques "exact", "off" and "broken" and the
/// skipped "sun-only", files in `folder`.
Results fake_results(const std::filesystem::path& folder);

}  // namespace umbrameter
