// SPDX-License-Identifier: Apache-2.0
#pragma once
// What one run of a technique starts from, and the numbers its expressions see.

#include "core/image.h"
#include "realtime/graph/expression.h"
#include "realtime/harness/gbuffer.h"
#include "realtime/harness/scene_buffers.h"
#include "realtime/manifest/technique.h"
#include "realtime/scene_data/scene_data.h"
#include "realtime/views/instance_boxes.h"
#include "realtime/views/light_view.h"
#include "scenes/scene.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace umbrameter {

/// Everything here must outlive the plan that is made from it.
struct RunInputs {
  const Technique& technique;
  const ParameterValues& values;  // complete
  const Scene& scene;
  const SceneBuffers& scene_buffers;
  SceneData& scene_data;   // of the same
  const GBuffer& gbuffer;  // also says the screen's size
  std::span<const ReceiverTile> receivers;
  std::span<const CasterCluster> casters;       // none: every triangle is drawn into every map
  std::span<const InstanceBox> instance_boxes;  // none: every instance is drawn into every map
  const Image& picture;                         // the G-buffer read back, for views that cover a part of it
  DistanceRange receiver_range;                 // along the camera's axis
  glm::dvec4 receiver_plane_world{0, 1, 0, 0};
  uint64_t seed = 1;
  std::filesystem::path shaders_folder;
  bool takes_blocker_truth = false;           // RenderRequest::blocker_truth
  int frame = 0;                              // counted from the first that is drawn
  const Camera* previous_camera = nullptr;    // of the frame before; null in the first
  const GBuffer* previous_gbuffer = nullptr;  // the same
  const Texture* blue_noise = nullptr;        // null where no pass reads it
};

/// Parameters, choices, built-in variables and the technique's own values: what expressions may use outside loops.
ExpressionVariables run_variables(const RunInputs& inputs);

/// Whether `condition` holds, as one that was left out does.
bool holds(const Expression& condition, const ExpressionVariables& variables);

/// The value of `expression` as a whole number from `min` to `max`; Error{input} naming `what` otherwise.
int64_t whole_number(const Expression& expression, const ExpressionVariables& variables, int64_t min,
                     int64_t max, std::string_view what);

}  // namespace umbrameter
