// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/run_views.h"

#include "core/sampling/sobol.h"
#include "realtime/executor/receivers.h"
#include "realtime/harness/frame_uniforms.h"
#include "realtime/views/camera_tiles.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <limits>

namespace umbrameter {
namespace {

constexpr int64_t kMaxViews = 64;

LightFit chosen_fit(const ViewDeclaration& declaration, const ParameterValues& values) {
  const auto parameter = values.find(declaration.fit);
  return find_light_fit(parameter == values.end() ? declaration.fit : to_text(parameter->second));
}

const ViewDeclaration& declared(const Technique& technique, const std::string& name) {
  const auto found = std::ranges::find(technique.views, name, &ViewDeclaration::name);
  UMBRAMETER_ASSERT(found != technique.views.end(), "view {}", name);
  return *found;
}

int64_t index_of(const ViewDeclaration& declaration, const ExpressionVariables& variables) {
  constexpr int64_t kLastFace = 5;
  switch (declaration.from) {
    case ViewOrigin::light_center:
      return 0;
    case ViewOrigin::light_sample:
      return whole_number(declaration.index, variables, 0, std::numeric_limits<uint32_t>::max(),
                          fmt::format("light sample of view '{}'", declaration.name));
    case ViewOrigin::light_face:
      return whole_number(declaration.index, variables, 0, kLastFace,
                          fmt::format("light face of view '{}'", declaration.name));
    case ViewOrigin::light_half:
      return whole_number(declaration.index, variables, 0, 1,
                          fmt::format("light half of view '{}'", declaration.name));
  }
  return 0;
}

std::optional<CameraSlice> slice_of(const ViewDeclaration& declaration,
                                    const ExpressionVariables& variables) {
  if (!declaration.slice_world) return std::nullopt;
  const auto& [from, to] = *declaration.slice_world;
  const CameraSlice slice{from.evaluate(variables), to.evaluate(variables)};
  if (slice.near_world >= 0.0 && slice.near_world < slice.far_world) return slice;
  fail_input(fmt::format("view '{}' covers a slice from {} to {}", declaration.name, slice.near_world,
                         slice.far_world),
             from.where(), "it must begin at 0 or later and end after that");
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

std::span<const FittedView> RunViews::get(const std::string& name, const ExpressionVariables& variables) {
  const ViewDeclaration& declaration = declared(inputs_.technique, name);
  const Settings settings = declaration.is_family() ? Settings{} : settings_of(declaration, variables);
  const auto key = std::tuple(name, settings.index, settings.texels);
  const auto found = fitted_.find(key);
  if (found != fitted_.end()) return found->second;
  std::vector<FittedView> views;
  if (declaration.is_family()) {
    views = fit_family(declaration);
  } else {
    views.push_back(fit(declaration, settings));
  }
  return fitted_.emplace(key, std::move(views)).first->second;
}

RunViews::Settings RunViews::settings_of(const ViewDeclaration& declaration,
                                         const ExpressionVariables& variables) const {
  constexpr int64_t kMaxTexels = 1 << 20;
  glm::dvec2 offset(0.0);
  if (declaration.offset_texels) {
    const auto& [right, up] = *declaration.offset_texels;
    offset = {right.evaluate(variables), up.evaluate(variables)};
  }
  return {.index = index_of(declaration, variables),
          .texels = static_cast<int>(whole_number(declaration.size, variables, 1, kMaxTexels,
                                                  fmt::format("size of view '{}'", declaration.name))),
          .snaps = !declaration.snap.is_empty() && holds(declaration.snap, variables),
          .offset_texels = offset,
          .slice = slice_of(declaration, variables)};
}

std::vector<FittedView> RunViews::fit_family(const ViewDeclaration& declaration) {
  ExpressionVariables variables = run_variables(inputs_);
  const int64_t count = whole_number(declaration.count, variables, 1, kMaxViews,
                                     fmt::format("count of view '{}'", declaration.name));
  std::vector<FittedView> views;
  for (int64_t index = 0; index < count; ++index) {
    variables[declaration.variable] = static_cast<double>(index);
    views.push_back(fit(declaration, settings_of(declaration, variables)));
  }
  return views;
}

std::span<const ReceiverTile> RunViews::covered(LightFit fit) {
  if (fit != LightFit::frustum && fit != LightFit::full) return inputs_.receivers;
  if (camera_tiles_.empty())
    camera_tiles_ = camera_tiles(inputs_.scene, inputs_.gbuffer.width(), inputs_.gbuffer.height());
  return camera_tiles_;
}

FittedView RunViews::fit(const ViewDeclaration& declaration, const Settings& settings) {
  FittedView fitted;
  fitted.view = light_view(declaration, settings);
  if (settings.snaps) fitted.view = snapped(fitted.view, settings.texels);
  if (settings.offset_texels != glm::dvec2(0.0))
    fitted.view = moved_aside(fitted.view, settings.offset_texels, settings.texels);
  fitted.data = make_light_view_data(fitted.view, settings.texels);
  fitted.mirrors = reverses_winding(fitted.view);
  return fitted;
}

LightView RunViews::light_view(const ViewDeclaration& declaration, const Settings& settings) {
  const Scene& scene = inputs_.scene;
  switch (declaration.from) {
    case ViewOrigin::light_center: {
      const LightFit chosen = chosen_fit(declaration, inputs_.values);
      if (settings.slice) return slice_view(chosen, *settings.slice);
      return fit_center_view(scene, covered(chosen), chosen);
    }
    case ViewOrigin::light_sample: {
      const LightFit chosen = chosen_fit(declaration, inputs_.values);
      const glm::vec2 uv = scrambled_sobol(static_cast<uint32_t>(settings.index), sample_seed_);
      return fit_sample_view(scene, covered(chosen), chosen, glm::dvec2(uv));
    }
    case ViewOrigin::light_face:
      if (!cube_range_) cube_range_ = cube_range(scene);
      return fit_face_view(scene, static_cast<int>(settings.index), *cube_range_);
    case ViewOrigin::light_half:
      if (!cube_range_) cube_range_ = cube_range(scene);
      return fit_half_view(scene, static_cast<int>(settings.index), *cube_range_);
  }
  return {};
}

LightView RunViews::slice_view(LightFit fit, const CameraSlice& slice) const {
  const std::vector<ReceiverTile> receivers = receiver_tiles(inputs_.picture, inputs_.scene.camera, slice);
  return fit_slice_view(inputs_.scene, {inputs_.gbuffer.width(), inputs_.gbuffer.height()}, receivers, fit,
                        slice);
}

std::vector<FittedView> RunViews::center() const {
  std::vector<FittedView> views;
  const std::string* first = nullptr;
  for (const auto& [key, fitted] : fitted_) {
    const std::string& name = std::get<0>(key);
    if (declared(inputs_.technique, name).from == ViewOrigin::light_sample) continue;
    if (first == nullptr) first = &name;
    if (name == *first) views.insert(views.end(), fitted.begin(), fitted.end());
  }
  return views;
}

std::optional<FittedView> RunViews::first_sample() const {
  for (const auto& [key, fitted] : fitted_) {
    if (declared(inputs_.technique, std::get<0>(key)).from == ViewOrigin::light_sample) return fitted.front();
  }
  return std::nullopt;
}

}  // namespace umbrameter
