// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shadow-map cameras, fitted on the CPU to what the camera sees. No GL.

#include "scenes/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// A box around the visible receivers of one screen tile; a scene's receivers are a list of these.
struct ReceiverTile {
  glm::vec3 min_world;
  glm::vec3 max_world;
};

/// The part of the camera's frustum between two distances along its axis.
struct CameraSlice {
  double near_world = 0.0;
  double far_world = 0.0;
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
  bool is_paraboloid = false;  // lateral: d.xy / (1 + d.z) of the unit direction d; distances run along it
  std::optional<CameraSlice> slice;  // what of the camera's frustum it covers, if that is not all
  glm::dvec4 camera_axis{0.0};       // with a slice: dot(camera_axis, (p_world, 1)) is the distance along it
};

/// What a map covers laterally, and its range of distances (TECHNIQUES 2.23):
/// - none: the scene's bounding sphere, whatever its shape;
/// - scene: the scene's box;
/// - frustum: the part of the scene's box inside the camera's frustum, at the scene's range of distances;
/// - full: the same, at its own range;
/// - visible: the receivers in the picture;
/// - sphere: the bounding sphere of a slice of the camera's frustum, as wide however the camera turns.
/// All but none and frustum add what penumbra searches reach into and take their nearest caster as the near plane.
enum class LightFit { none, frustum, scene, full, visible, sphere };
/// Their names, in the order of the enumeration.
std::span<const std::string> light_fits();
LightFit find_light_fit(std::string_view name);

/// Whether a fit can cover a slice alone: frustum, full, visible, sphere.
bool follows_slice(LightFit fit);

/// The view from the light's centre (sun: along its direction), its map plane parallel to rect and disk
/// lights. Perspective bounds are limited to tan(80 deg); what falls outside counts as lit and is reported by the
/// renderer.
/// `covered`: what frustum, full (camera_tiles) or visible (the receivers) cover.
LightView fit_center_view(const Scene& scene, std::span<const ReceiverTile> covered, LightFit fit);

/// The view from one point of the light (light_point(light, uv)), same plane, without a search margin.
LightView fit_sample_view(const Scene& scene, std::span<const ReceiverTile> covered, LightFit fit,
                          const glm::dvec2& light_uv);

/// A sun's view of what a slice of the frustum shows. `covered`: the receivers in it, which visible covers; without any,
/// and with the other fits, it covers the slice itself.
LightView fit_slice_view(const Scene& scene, const glm::ivec2& screen_px,
                         std::span<const ReceiverTile> covered, LightFit fit, const CameraSlice& slice);

/// Nearest and farthest distance, along their own axes, of anything in the six faces of the cube around the light's
/// centre: all of them share it, so that stored depths can be compared across their edges.
struct DistanceRange {
  double near_world = 0.0;
  double far_world = 0.0;
};
DistanceRange cube_range(const Scene& scene);

/// The view from the light's centre through one face, 0 to 5: the right angle around +x, -x, +y, -y, +z, -z of the world,
/// turned and mirrored as GL samples the face of a cube map.
LightView fit_face_view(const Scene& scene, int face, const DistanceRange& range);

/// The view from the light's centre that holds the half of all directions around its own (0), or the other (1), as a paraboloid
/// reflects them. Has no clip_from_light: shaders of its own draw it (realtime/shaders/paraboloid).
LightView fit_half_view(const Scene& scene, int half, const DistanceRange& range);

/// The view with a map that moves in whole texels only when the camera does: its width takes steps of 2^(1/4) and its
/// corner lies on a multiple of a texel.
LightView snapped(const LightView& view, int texels_a_side);

/// The view with its map moved aside by parts of its texels.
LightView moved_aside(const LightView& view, const glm::dvec2& offset_texels, int texels_a_side);

/// Distance along the camera's axis as a plane: dot(it, (p_world, 1)).
glm::dvec4 camera_axis(const Camera& camera);

/// Whether a view's map, or its slice, holds a world point.
bool covers(const LightView& view, const glm::dvec3& p_world);

/// Lateral coordinates and distance of a world point in a view.
glm::dvec3 lateral_and_distance(const LightView& view, const glm::dvec3& p_world);

}  // namespace umbrameter
