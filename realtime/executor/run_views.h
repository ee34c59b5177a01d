// SPDX-License-Identifier: Apache-2.0
#pragma once
// The light views of a run, fitted once each before anything is drawn.

#include "realtime/executor/run_inputs.h"
#include "realtime/shaders/shared/frame_data.h"

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace umbrameter {

struct FittedView {
  LightView view;
  LightViewData data;
  bool mirrors = false;  // clip space shows the winding of triangles reversed
};

class RunViews {
 public:
  explicit RunViews(const RunInputs& inputs);

  /// The view named `name`, for the loop variables in `variables`: one, or all of a family. The span stays valid.
  std::span<const FittedView> get(const std::string& name, const ExpressionVariables& variables);
  /// The first name's views from the light's centre, when passes used any.
  std::vector<FittedView> center() const;
  /// The first view from a sample of the light, when a pass used one.
  std::optional<FittedView> first_sample() const;

 private:
  /// What tells one fit of a view from another.
  struct Settings {
    int64_t index = 0;  // of light.sample or light.face
    int texels = 0;
    bool snaps = false;
    glm::dvec2 offset_texels{0.0};
    std::optional<CameraSlice> slice;
  };

  Settings settings_of(const ViewDeclaration& declaration, const ExpressionVariables& variables) const;
  std::vector<FittedView> fit_family(const ViewDeclaration& declaration);
  FittedView fit(const ViewDeclaration& declaration, const Settings& settings);
  LightView light_view(const ViewDeclaration& declaration, const Settings& settings);
  LightView slice_view(LightFit fit, const CameraSlice& slice) const;
  std::span<const ReceiverTile> covered(LightFit fit);

  const RunInputs& inputs_;
  std::vector<ReceiverTile> camera_tiles_;
  std::optional<DistanceRange> cube_range_;
  uint32_t sample_seed_;
  std::map<std::tuple<std::string, int64_t, int>, std::vector<FittedView>>
      fitted_;  // by name, and of single views by index and texels
};

}  // namespace umbrameter
