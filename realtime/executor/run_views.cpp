// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/run_views.h"

#include "core/sampling/sobol.h"
#include "realtime/harness/frame_uniforms.h"
#include "realtime/views/camera_tiles.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

namespace umbrameter {
namespace {

constexpr int64_t kCenter = -1;

LightFit chosen_fit(const ViewDeclaration& declaration, const ParameterValues& values) {
  const auto parameter = values.find(declaration.fit);
  const std::string fit = parameter == values.end() ? declaration.fit : to_text(parameter->second);
  const auto found = std::ranges::find(light_fits(), fit);
  UMBRAMETER_ASSERT(found != light_fits().end(), "fit {}", fit);
  return static_cast<LightFit>(found - light_fits().begin());
}

/// Clip space is left-handed as seen (x right, y up, depth away), so a view mirrors unless its rotation and
/// the signs of its scales make up for that.
bool reverses_winding(const LightView& view) {
  const float rotation = glm::determinant(glm::mat3(view.light_from_world));
  return rotation * view.clip_from_light[0][0] * view.clip_from_light[1][1] > 0.0f;
}

}  // namespace

RunViews::RunViews(const RunInputs& inputs)
    : inputs_(inputs),
      sample_seed_(
          hash_combine(static_cast<uint32_t>(inputs.seed), static_cast<uint32_t>(inputs.seed >> 32))) {}

const FittedView& RunViews::get(const std::string& name, const ExpressionVariables& variables) {
  constexpr int64_t kMaxTexels = 1 << 20;
  const auto& views = inputs_.technique.views;
  const auto declaration = std::ranges::find(views, name, &ViewDeclaration::name);
  UMBRAMETER_ASSERT(declaration != views.end(), "view {}", name);
  const auto texels = static_cast<int>(
      whole_number(declaration->size, variables, 1, kMaxTexels, fmt::format("size of view '{}'", name)));
  const int64_t sample =
      declaration->from == ViewOrigin::light_center
          ? kCenter
          : whole_number(declaration->sample, variables, 0, std::numeric_limits<uint32_t>::max(),
                         fmt::format("light sample of view '{}'", name));
  const auto key = std::tuple(name, sample, texels);
  const auto found = fitted_.find(key);
  if (found != fitted_.end()) return found->second;
  const bool snaps = !declaration->snap.is_empty() && holds(declaration->snap, variables);
  return fitted_.emplace(key, fit(*declaration, sample, texels, snaps)).first->second;
}

std::span<const ReceiverTile> RunViews::covered(LightFit fit) {
  if (fit != LightFit::frustum && fit != LightFit::full) return inputs_.receivers;
  if (camera_tiles_.empty())
    camera_tiles_ = camera_tiles(inputs_.scene, inputs_.gbuffer.width(), inputs_.gbuffer.height());
  return camera_tiles_;
}

FittedView RunViews::fit(const ViewDeclaration& declaration, int64_t sample, int texels_a_side, bool snaps) {
  const LightFit chosen = chosen_fit(declaration, inputs_.values);
  FittedView fitted;
  if (sample == kCenter) {
    fitted.view = fit_center_view(inputs_.scene, covered(chosen), chosen);
  } else {
    const glm::vec2 uv = scrambled_sobol(static_cast<uint32_t>(sample), sample_seed_);
    fitted.view = fit_sample_view(inputs_.scene, covered(chosen), chosen, glm::dvec2(uv));
  }
  if (snaps) fitted.view = snapped(fitted.view, texels_a_side);
  fitted.data = make_light_view_data(fitted.view, texels_a_side);
  fitted.mirrors = reverses_winding(fitted.view);
  return fitted;
}

std::optional<FittedView> RunViews::center() const {
  for (const auto& [key, fitted] : fitted_) {
    if (std::get<1>(key) == kCenter) return fitted;
  }
  return std::nullopt;
}

std::optional<FittedView> RunViews::first_sample() const {
  for (const auto& [key, fitted] : fitted_) {
    if (std::get<1>(key) != kCenter) return fitted;
  }
  return std::nullopt;
}

}  // namespace umbrameter
