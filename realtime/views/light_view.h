#pragma once
// Shadow-map cameras, fitted on the CPU to what the camera sees. No GL.

#include "scenes/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace umbrameter {

/// A box around the visible receivers of one screen tile; a scene's receivers are a list of these.
struct ReceiverTile {
  glm::vec3 min_world;
  glm::vec3 max_world;
};

/// One shadow-map view. Light space: x = tangent, y = bitangent, z = distance along `direction` from the
/// viewpoint (perspective) or from the plane through the scene's nearest caster (orthographic).
/// Lateral coordinates are tan space (x/z, y/z) for perspective, world units for orthographic.
struct LightView {
  glm::mat4 light_from_world{1.0f};
  glm::mat4 clip_from_light{1.0f};  // reversed depth, zero to one
  glm::vec4 lateral_bounds{0.0f};   // x min, y min, x max, y max
  float near_world = 0.0f;
  float far_world = 0.0f;
  bool is_orthographic = false;
};

enum class LightFit { visible, scene };

/// The view from the light's centre (sun: along its direction), its map plane parallel to rect and disk
/// lights. `fit` visible: lateral bounds cover the receiver tiles plus the margin that penumbra searches
/// reach into; scene: they cover all geometry in front of the light. Perspective bounds are limited to tan(80
/// deg); what falls outside counts as lit and is reported by the renderer.
LightView fit_center_view(const Scene& scene, std::span<const ReceiverTile> receivers, LightFit fit);

/// The view from one point of the light (light_point(light, uv)), same plane, without a search margin.
LightView fit_sample_view(const Scene& scene, std::span<const ReceiverTile> receivers, LightFit fit,
                          const glm::dvec2& light_uv);

/// Lateral coordinates and distance of a world point in a view.
glm::dvec3 lateral_and_distance(const LightView& view, const glm::dvec3& p_world);

}  // namespace umbrameter
