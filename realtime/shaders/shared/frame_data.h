// SPDX-License-Identifier: Apache-2.0
// The uniform blocks every shader sees. Read by C++ and by GLSL, so: std140, members of 16 bytes only.
// GLSL gets this text in its prelude (no #include here, no #version).
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
namespace umbrameter {
using glm::ivec4;
using glm::mat4;
using glm::vec4;
#endif

struct FrameData {
  mat4 clip_from_world;  // reversed depth, zero to one, infinite far
  vec4 eye_world;        // xyz, w = 1
  vec4 light_center_world;
  vec4 light_tangent_world;
  vec4 light_bitangent_world;
  vec4 light_direction_world;  // away from the light
  vec4 light_extent;  // rect: half width, half height; disk, sphere: radius twice; sun: tan(half angle) twice
  ivec4 light_type;   // x: 0 rect, 1 disk, 2 sphere, 3 sun
  ivec4 screen_and_seed;  // width px, height px, low 31 bits of the seed, 0
  vec4
      receiver_plane_world;  // the plane most receivers lie on: unit normal towards the camera, n . p + w = 0
};

// Light space: x tangent, y bitangent, z distance along the light's direction from the viewpoint.
struct LightViewData {
  mat4 light_from_world;
  mat4 clip_from_light;
  vec4
      lateral_bounds;  // x min, y min, x max, y max: x/z, y/z when perspective, world units when orthographic
  vec4 depth_range;    // near_world, far_world, is_orthographic (0 or 1), texels a side
  vec4 slice_world;    // from, to: the distances along the camera's axis that it covers; 0, 0: all; 0, 0
};

// What techniques with history see as `history`.
struct HistoryData {
  mat4 previous_clip_from_world;  // of the frame before, as clip_from_world
  vec4 previous_eye_world;        // xyz, w = 1
  vec4 jitter;                    // xy: of this frame, zw: of the one before; Halton points 2, 3 less a half
  ivec4 frame;  // x: counted from the first frame that is drawn, 0: nothing was before; 0, 0, 0
};

#ifdef __cplusplus
static_assert(sizeof(FrameData) == 208 && sizeof(LightViewData) == 176);
static_assert(offsetof(FrameData, eye_world) == 64 && offsetof(FrameData, light_center_world) == 80);
static_assert(offsetof(FrameData, light_tangent_world) == 96 &&
              offsetof(FrameData, light_bitangent_world) == 112);
static_assert(offsetof(FrameData, light_direction_world) == 128 && offsetof(FrameData, light_extent) == 144);
static_assert(offsetof(FrameData, light_type) == 160 && offsetof(FrameData, screen_and_seed) == 176);
static_assert(offsetof(FrameData, receiver_plane_world) == 192);
static_assert(offsetof(LightViewData, clip_from_light) == 64);
static_assert(offsetof(LightViewData, lateral_bounds) == 128 && offsetof(LightViewData, depth_range) == 144);
static_assert(offsetof(LightViewData, slice_world) == 160);
static_assert(sizeof(HistoryData) == 112 && offsetof(HistoryData, previous_eye_world) == 64);
static_assert(offsetof(HistoryData, jitter) == 80 && offsetof(HistoryData, frame) == 96);
}  // namespace umbrameter
#endif
