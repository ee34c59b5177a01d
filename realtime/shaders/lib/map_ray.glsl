// SPDX-License-Identifier: Apache-2.0
// A ray through the map. Lateral coordinates and stored depth change evenly along it together, for lamps too. For techniques
// with the parameters of the group map_rays; they say what the map holds: stored_depth().
#include "shadow_map.glsl"

/// Reversed, of the texel in the map; 0 for nothing.
float stored_depth(ivec2 texel);

struct MapRay {
  vec3 start;  // lateral coordinates and stored depth (reversed: nearer to the light is more) at the receiver
  vec3 step;   // from there to the far end
};

/// Stored depth of a distance, also outside the map's range.
float open_depth(LightViewData view, float distance_world) {
  float near_world = view.depth_range.x;
  float far_world = view.depth_range.y;
  float share = (far_world - distance_world) / (far_world - near_world);
  return is_orthographic(view) ? share : share * near_world / distance_world;
}

vec3 in_map(LightViewData view, vec3 p_light) { return vec3(lateral_of(view, p_light), open_depth(view, p_light.z)); }

MapRay map_ray(LightViewData view, vec3 p_light, vec3 way) {
  vec3 start = in_map(view, p_light);
  return MapRay(start, in_map(view, p_light + way) - start);
}

/// What was seen of the surfaces beside the ray.
struct SeenSurface {
  float height;  // stored depth over that of the receiver's own surface there: what is hidden goes on beside that
  float time;    // where along the ray, 0 at the receiver; below 0: nothing yet
  float slope;
};

/// Steepest change of stored depth along the whole ray that is gone on with.
float steepest(LightViewData view, MapRay ray) {
  if (EXTRAPOLATION == 0) return 0.0;
#ifdef LAMP_RAYS
  if (!is_orthographic(view)) return lamp_slope * abs(ray.step.z);
#endif
  return sun_slope_world / (view.depth_range.y - view.depth_range.x);
}

/// The surface goes on where this texel shows it, and keeps its slope.
void see(inout SeenSurface seen, float height, float time, float limit) {
  if (seen.time >= 0.0 && height != seen.height)
    seen.slope = clamp((height - seen.height) / (time - seen.time), -limit, limit);
  if (seen.time < 0.0 || height != seen.height) {
    seen.height = height;
    seen.time = time;
  }
}

/// Stored depth that a texel's surface must be over to block the receiver.
float own_depth(LightViewData view, Receiver receiver, ivec2 texel) {
  return open_depth(view, compare_distance(view, receiver, lateral_of_texel(view, vec2(texel) + 0.5)));
}

/// What stands at the far end of a ray that goes as far as blockers do: seen, but in nobody's way.
SeenSurface seen_at_end(LightViewData view, Receiver receiver, MapRay ray) {
  ivec2 texel = texel_at(view, ray.start.xy + ray.step.xy);
  float depth = is_in_map(view, texel) ? stored_depth(texel) : 0.0;
  return SeenSurface(depth - own_depth(view, receiver, texel), 1.0, 0.0);
}

/// Place `index` of samples + 1 along the ray: squares, jittered, and the receiver last.
float sample_time(int index, float noise) {
  if (index == SAMPLES) return 0.0;
  float root = (float(SAMPLES - 1 - index) + noise) / float(SAMPLES);
  return root * root;
}

/// Whether a surface of the map stands in the ray's way. What does not come before the receiver's own surface never does.
bool is_stopped(LightViewData view, Receiver receiver, MapRay ray, float noise) {
  const float kTolerance = 1.05;  // const: of a step, so that rounding opens no gaps between steps; as in Unreal
  float limit = steepest(view, ray);
  SeenSurface seen = SeenSurface(0.0, -1.0, 0.0);
  if (RAY_REACH == RAY_REACH_BLOCKERS) seen = seen_at_end(view, receiver, ray);
  float before = ray.start.z + ray.step.z;
  for (int i = 0; i <= SAMPLES; ++i) {
    float time = sample_time(i, noise);
    vec3 at = ray.start + time * ray.step;
    ivec2 texel = texel_at(view, at.xy);
    if (!is_in_map(view, texel)) continue;
    float depth = stored_depth(texel);
    float own = own_depth(view, receiver, texel);
    bool is_first = seen.time < 0.0;
    float thickness = is_first ? 1.0 : kTolerance * abs(at.z - before);
    before = at.z;
    bool is_hidden = depth > own && depth - at.z > thickness;
    float met = is_hidden ? own + seen.height + seen.slope * (time - seen.time) : depth;
    if (!is_hidden) see(seen, depth - own, time, limit);
    if (met > own && met > at.z && met - at.z <= thickness) return true;
  }
  return false;
}
