// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/texel_planes.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace umbrameter {
namespace {

std::optional<double> real_parameter(const ParameterValues& parameters, const char* name) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) return std::nullopt;
  const double* value = std::get_if<double>(&found->second);
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

const FittedView* map_of(std::span<const FittedView> maps, const glm::dvec3& p_world) {
  if (maps.size() == 1) return &maps.front();
  const auto found =
      std::ranges::find_if(maps, [&](const FittedView& map) { return covers(map.view, p_world); });
  return found == maps.end() ? nullptr : &*found;
}

/// World width, facing the light at lateral place and distance `p`, of a lateral step.
double width_of_step(const LightView& view, const glm::dvec3& p) {
  if (view.is_orthographic) return 1.0;
  return view.is_paraboloid ? 2.0 * p.z / (1.0 + p.x * p.x + p.y * p.y) : p.z;
}

}  // namespace

void add_texel_planes(std::span<const FittedView> maps, Image& image) {
  const std::span<float> u = image.add_plane("texel.x");
  const std::span<float> v = image.add_plane("texel.y");
  const std::span<float> width_world = image.add_plane("texel_world");
  const auto x = image.plane("position.x"), y = image.plane("position.y"), z = image.plane("position.z");
  const auto primitive = image.plane("primitive_id");
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    if (primitive[i] < 0.0f) continue;
    const glm::dvec3 p_world(x[i], y[i], z[i]);
    const FittedView* fitted = map_of(maps, p_world);
    if (fitted == nullptr) continue;
    const LightView& view = fitted->view;
    const glm::dvec3 p = lateral_and_distance(view, p_world);
    if (!view.is_orthographic && p.z <= 0.0) continue;
    const glm::dvec4 bounds(view.lateral_bounds);
    const double texels = fitted->data.depth_range.w;
    const glm::dvec2 texel = {(bounds.z - bounds.x) / texels, (bounds.w - bounds.y) / texels};
    u[i] = static_cast<float>((p.x - bounds.x) / texel.x);
    v[i] = static_cast<float>((p.y - bounds.y) / texel.y);
    width_world[i] = static_cast<float>(std::max(texel.x, texel.y) * width_of_step(view, p));
  }
}

Image map_indices(std::span<const FittedView> maps, const Image& image) {
  Image indices(image.width, image.height);
  const std::span<float> index = indices.add_plane("Y");
  const auto x = image.plane("position.x"), y = image.plane("position.y"), z = image.plane("position.z");
  const auto primitive = image.plane("primitive_id");
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const FittedView* map = primitive[i] < 0.0f ? nullptr : map_of(maps, {x[i], y[i], z[i]});
    index[i] = map == nullptr ? -1.0f : static_cast<float>(map - maps.data());
  }
  return indices;
}

void add_bias_plane(const ParameterValues& parameters, Image& image) {
  const auto mode = parameters.find("bias_mode");
  if (mode != parameters.end() && mode->second == ParameterValue(std::string("auto"))) return;
  const std::optional<double> world = real_parameter(parameters, "bias_world"),
                              texels = real_parameter(parameters, "bias_texels"),
                              offset_texels = real_parameter(parameters, "normal_offset_texels");
  if (!world && !texels && !offset_texels) return;
  const std::span<float> bias_world = image.add_plane("bias_world");
  const std::span<const float> texel_world = std::as_const(image).plane("texel_world");
  for (size_t i = 0; i < bias_world.size(); ++i) {
    const double sum =
        world.value_or(0.0) + (texels.value_or(0.0) + offset_texels.value_or(0.0)) * texel_world[i];
    if (texel_world[i] > 0.0f) bias_world[i] = static_cast<float>(sum);
  }
}

}  // namespace umbrameter
