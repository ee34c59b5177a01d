// SPDX-License-Identifier: Apache-2.0
// A ray from a pixel's surface towards the light's centre, followed through the G-buffer: blockers that the camera sees. For
// fullscreen passes that read gbuffer.position and gbuffer.normal, in techniques with the parameters of the group screen_trace.
#include "sampling.glsl"
#include "spaces.glsl"

/// Direction to the light's centre, unit.
vec3 to_light_center(vec3 p_world) {
  const int kSunType = 3;  // const: FrameData.light_type
  if (frame.light_type.x == kSunType) return -frame.light_direction_world.xyz;
  return normalize(frame.light_center_world.xyz - p_world);
}

/// Place in the picture in pixels (GL's rows), and one over the distance along the camera's axis: even along a ray.
vec3 on_screen(vec3 p_world) {
  vec4 clip = frame.clip_from_world * vec4(p_world, 1.0);
  return vec3((0.5 * clip.xy / clip.w + 0.5) * vec2(frame.screen_and_seed.xy), 1.0 / clip.w);
}

/// Width of a pixel in the world at a distance along the camera's axis.
float pixel_world(float distance_world) {
  vec3 up = vec3(frame.clip_from_world[0].y, frame.clip_from_world[1].y, frame.clip_from_world[2].y);
  return 2.0 * distance_world / (length(up) * float(frame.screen_and_seed.y));
}

/// Whether the surface in pixel `px` comes before the receiver's tangent plane.
bool stands_out(ivec2 px, vec3 p_world, vec3 n_world, float height_world) {
  vec4 p_other = texelFetch(gbuffer_position, px, 0);
  return p_other.w != 0.0 && (own_plane_px == 0.0 || dot(n_world, p_other.xyz - p_world) > height_world);
}

/// Whether something in the picture stands between `p_world` and `p_world` + `way_world`.
bool meets_on_screen(vec3 p_world, vec3 n_world, vec3 way_world) {
  vec3 start = on_screen(p_world);
  float height_world = own_plane_px * pixel_world(1.0 / start.z);
  float nearer_world = 1.0 / start.z - length(way_world);
  if (nearer_world <= 0.0) return false;  // the camera is within reach
  vec3 way = on_screen(p_world + way_world) - start;
  float thickness = thickness_steps * (1.0 / nearer_world - start.z) / float(STEPS);
  vec2 p_noise = seeded_position(pixel_position(gl_FragCoord.xy, float(frame.screen_and_seed.y)), frame.screen_and_seed.z);
  float shift = JITTER != 0 ? interleaved_gradient_noise(p_noise) - 0.5 : 0.0;
  for (int i = 0; i < STEPS; ++i) {
    vec3 at = start + way * ((float(i) + 1.0 + shift) / float(STEPS));
    ivec2 px = ivec2(floor(at.xy));
    if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, frame.screen_and_seed.xy))) return false;
    if (!stands_out(px, p_world, n_world, height_world)) continue;
    float over = on_screen(texelFetch(gbuffer_position, px, 0).xyz).z - at.z;
    if (over > 0.0 && over < thickness) return true;
  }
  return false;
}

/// 0 where the picture shows a blocker, or the surface is turned away from the light's centre.
float screen_visibility() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec3 p_world = texelFetch(gbuffer_position, px, 0).xyz;
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  vec3 direction = to_light_center(p_world);
  if (dot(n_world, direction) <= 0.0) return 0.0;
  return meets_on_screen(p_world, n_world, direction * length_world) ? 0.0 : 1.0;
}
