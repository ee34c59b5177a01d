// Percentage-closer soft shadows (Fernando 2005) with kernels shaped like the light: search for blockers, place a
// plane at their mean distance, and ask the map along the rays from the receiver through that plane to the light.
#include "area_light.glsl"
#include "pixel.glsl"
#include "shadow_map.glsl"

/// Blockers anywhere between the view's near plane and the receiver lie on its rays through the near plane.
/// Their mean distance, or the receiver's own for none.
float mean_blocker_distance(AreaLight light, Receiver receiver, vec2 noise) {
  bool is_harmonic = AVERAGE == AVERAGE_HARMONIC && !is_orthographic(view_light);
  float slack = texel_lateral(view_light);
  float sum = 0.0;
  float count = 0.0;
  for (int i = 0; i < SEARCH_TAPS; ++i) {
    vec2 kernel = focused(light, kernel_point(light, i, SEARCH_TAPS, noise), search_focus);
    vec3 ray = ray_to_light(light, receiver, kernel);
    if (ray.z >= 0.0 || !faces(receiver, ray)) continue;
    vec2 lateral = lateral_on_ray(view_light, receiver, ray, view_light.depth_range.x);
    ivec2 texel = texel_at(view_light, lateral);
    float z_blocker;
    if (!find_blocker(shadow_map, view_light, receiver, texel, z_blocker)) continue;
    vec2 lateral_blocker = lateral_of_texel(view_light, vec2(texel) + 0.5);
    if (SEARCH_CONE != 0 && !is_in_light_cone(light, view_light, receiver, lateral_blocker, z_blocker, slack)) continue;
    sum += is_harmonic ? 1.0 / z_blocker : z_blocker;
    count += 1.0;
  }
  if (count == 0.0) return receiver.p_light.z;
  return is_harmonic ? count / sum : sum / count;
}

/// Share of the light's points whose rays pass the map at `z_blocker`; those below the receiver's horizon do not.
float visible_share(AreaLight light, Receiver receiver, float z_blocker, vec2 noise) {
  bool has_blocker = z_blocker < receiver.p_light.z;
  float seen = 0.0;
  for (int i = 0; i < FILTER_TAPS; ++i) {
    vec3 ray = ray_to_light(light, receiver, kernel_point(light, i, FILTER_TAPS, noise));
    if (!faces(receiver, ray)) continue;
    bool is_open = !has_blocker || ray.z >= 0.0;
    if (!is_open) {
      vec2 lateral = lateral_on_ray(view_light, receiver, ray, z_blocker);
      is_open = !is_blocked(shadow_map, view_light, receiver, texel_at(view_light, lateral));
    }
    if (is_open) seen += 1.0;
  }
  return seen / float(FILTER_TAPS);
}

vec2 pixel_noise() {
  if (NOISE == 0) return vec2(0.0);
  vec2 p_px = noise_position();
  return vec2(interleaved_gradient_noise(p_px), interleaved_gradient_noise(p_px.yx));
}

float visibility_of(Receiver receiver) {
  AreaLight light = AreaLight(frame.light_type.x, frame.light_extent.xy);
  vec2 noise = pixel_noise();
  bool is_outside = is_behind(view_light, receiver);
  float z_blocker = is_outside ? receiver.p_light.z : mean_blocker_distance(light, receiver, noise);
  return visible_share(light, receiver, z_blocker, noise);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
