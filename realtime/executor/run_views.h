// SPDX-License-Identifier: Apache-2.0
#pragma once
// The light views of a run, fitted once each before anything is drawn.

#include "realtime/executor/run_inputs.h"
#include "realtime/shaders/shared/frame_data.h"

#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace umbrameter {

struct FittedView {
  LightView view;
  LightViewData data;
  bool mirrors = false;  // clip space shows the winding of triangles reversed
};

class RunViews {
 public:
  explicit RunViews(const RunInputs& inputs);

  /// The view named `name`, for the loop variables in `variables`. The reference stays valid.
  const FittedView& get(const std::string& name, const ExpressionVariables& variables);
  /// The view from the light's centre, when a pass used one.
  std::optional<FittedView> center() const;
  /// The first view from a sample of the light, when a pass used one.
  std::optional<FittedView> first_sample() const;

 private:
  FittedView fit(const ViewDeclaration& declaration, int64_t sample, int texels_a_side, bool snaps);
  std::span<const ReceiverTile> covered(LightFit fit);

  const RunInputs& inputs_;
  std::vector<ReceiverTile> camera_tiles_;
  uint32_t sample_seed_;
  std::map<std::tuple<std::string, int64_t, int>, FittedView>
      fitted_;  // by name, sample (-1: centre), texels
};

}  // namespace umbrameter
