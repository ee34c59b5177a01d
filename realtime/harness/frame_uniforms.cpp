// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/frame_uniforms.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

glm::vec4 vector4(const glm::dvec3& v, double w) {
  return glm::vec4(glm::vec3(v), static_cast<float>(w));
}

glm::dvec2 light_extent(const Light& light) {
  if (light.type == LightType::rect) return 0.5 * light.size_world;
  if (light.type == LightType::sun) return glm::dvec2(std::tan(light.half_angle_rad));
  return glm::dvec2(light.radius_world);
}

double radical_inverse(int index, int base) {
  double inverse = 0.0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base) inverse += digit * (index % base);
  return inverse;
}

}  // namespace

FrameData make_frame_data(const Scene& scene, int width_px, int height_px, uint64_t seed) {
  const Light& light = scene.light();
  FrameData data{};
  data.clip_from_world = glm::mat4(clip_from_world(scene.camera, width_px, height_px));
  data.eye_world = vector4(scene.camera.eye_world, 1.0);
  data.light_center_world = vector4(light.center_world, 1.0);
  data.light_tangent_world = vector4(light.tangent_world, 0.0);
  data.light_bitangent_world = vector4(light.bitangent_world, 0.0);
  data.light_direction_world = vector4(light.direction_world, 0.0);
  data.light_extent = glm::vec4(glm::vec2(light_extent(light)), 0.0f, 0.0f);
  data.light_type = glm::ivec4(static_cast<int>(light.type), 0, 0, 0);
  data.screen_and_seed = glm::ivec4(width_px, height_px, static_cast<int>(seed & 0x7fffffffu), 0);
  return data;
}

glm::dvec2 frame_jitter(int frame) {
  return {radical_inverse(frame + 1, 2) - 0.5, radical_inverse(frame + 1, 3) - 0.5};
}

HistoryData make_history_data(const Camera& previous, int frame, int width_px, int height_px) {
  const glm::dvec2 now = frame_jitter(frame), before = frame_jitter(std::max(frame - 1, 0));
  HistoryData data{};
  data.previous_clip_from_world = glm::mat4(clip_from_world(previous, width_px, height_px));
  data.previous_eye_world = vector4(previous.eye_world, 1.0);
  data.jitter = glm::vec4(glm::vec2(now), glm::vec2(before));
  data.frame = glm::ivec4(frame, 0, 0, 0);
  return data;
}

LightViewData make_light_view_data(const LightView& view, int texels_a_side) {
  LightViewData data{};
  data.light_from_world = view.light_from_world;
  data.clip_from_light = view.clip_from_light;
  data.lateral_bounds = view.lateral_bounds;
  data.depth_range = glm::vec4(view.near_world, view.far_world, view.is_orthographic ? 1.0f : 0.0f,
                               static_cast<float>(texels_a_side));
  if (view.slice)
    data.slice_world = {static_cast<float>(view.slice->near_world), static_cast<float>(view.slice->far_world),
                        0, 0};
  return data;
}

}  // namespace umbrameter
