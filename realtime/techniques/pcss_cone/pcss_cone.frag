// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows of a sun along its cone of rays: taps of search and filter are compared nearer to the light the
// farther they lie off the receiver's own ray (Unity HDRP's sun).
#include "blocker_truth.glsl"
#include "kernel_light.glsl"
#include "pixel.glsl"
#include "shadow_map.glsl"

/// Tangents of half angles, all in lateral units for a unit of drop.
struct Cones {
  float light;    // of the filter
  float search;   // a blocker counts inside of it
  float least;    // the same, within the least radius
};

float tangent_of_diameter(float diameter_deg) { return tan(0.5 * radians(diameter_deg)); }

Cones cones_of(AreaLight light) {
  float own = light.half_extent.x / light.scale;
  float search = max(tangent_of_diameter(search_angle_deg), own);
  float least = max(tangent_of_diameter(least_filter_angle_deg), search);
  return Cones(light.half_extent.x, light.scale * search, light.scale * least);
}

vec2 spiral(int index, float turn_rad) {
  float angle_rad = float(index) * kGoldenAngleRad + turn_rad;
  return vec2(cos(angle_rad), sin(angle_rad));
}

/// Mean distance of the blockers inside the cone; the receiver's own for none.
float search_cone(Receiver receiver, Cones cones, float radius, float least_radius, float turn_rad) {
  float sum = 0.0;
  float count = 0.0;
  for (int i = 0; i < SEARCH_TAPS; ++i) {
    float off_ray = radius * pow(float(i) / float(SEARCH_TAPS), search_clump);
    vec2 lateral_met;
    float z_met;
    vec2 lateral = receiver.lateral + off_ray * spiral(i, turn_rad);
    if (!find_blocker_at(shadow_map, view_light, receiver, lateral, lateral_met, z_met)) continue;
    float tangent = off_ray < least_radius ? cones.least : cones.search;
    if (z_met >= receiver.p_light.z - off_ray / tangent) continue;
    sum += z_met;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : receiver.p_light.z;
}

float filter_cone(Receiver receiver, Cones cones, float drop, float least_radius, float turn_rad) {
  float radius = drop * cones.light;
  float most_offset = min(max_offset_world, max_offset_share * drop);
  float lit = 0.0;
  for (int i = 0; i < FILTER_TAPS; ++i) {
    float share = sqrt((float(i) + 0.5) / float(FILTER_TAPS));
    vec2 lateral = receiver.lateral + max(radius, least_radius) * share * spiral(i, turn_rad);
    Receiver tap = receiver;
    tap.bias_world += min(radius * share / cones.least, most_offset);
    lit += bilinear_lit(shadow_map, view_light, tap, texel_position(view_light, lateral));
  }
  return lit / float(FILTER_TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  Cones cones = cones_of(kernel_light());
  float turn_rad = kTwoPi * interleaved_gradient_noise(noise_position());
  float least_radius = least_filter_texels * texel_lateral(view_light);
  float reach = max_radius_world / cones.light;
  float z_receiver = receiver.p_light.z;
  float to_near = max(0.0, z_receiver - view_light.depth_range.x);
  float search_radius = max(min(to_near, reach) * cones.light, least_radius);
  float z_blocker = search_cone(receiver, cones, search_radius, least_radius, turn_rad);
#ifdef BLOCKER_FROM_TRUTH
  z_blocker = true_blocker_distance(view_light, receiver);
#endif
  if (z_blocker >= z_receiver) return 1.0;
  return filter_cone(receiver, cones, min(cone_share * (z_receiver - z_blocker), reach), least_radius, turn_rad);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
