// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over a cube of maps: taps on a disk around the receiver's direction, each a comparison of
// the hardware's, blended over four texels that may lie on two faces.
#include "map_cube.glsl"

#include "pixel.glsl"

/// The least distance, along the axis of the face, at which the four texels blended in `direction_world` (1 long along
/// that axis) hold the tangent plane, which that direction meets at `z_plane`. A plane n.p = c lies at c / n.d in the
/// direction d. Texels a width w aside change d by at most w across the axis; beyond a face's edge those of the next face
/// lie half a texel behind the corner too.
float nearest_blended_distance(Receiver receiver, vec3 direction_world, float z_plane) {
  float width = 2.0 / view_light.depth_range.w;
  vec3 size = abs(direction_world);
  vec3 n = abs(transpose(mat3(view_light.light_from_world)) * receiver.n_light);
  float along_axis = n[face_of(direction_world) / 2];
  bvec3 is_beyond = greaterThan(size, vec3(1.0 - 0.5 * width));
  bool is_at_edge = int(is_beyond.x) + int(is_beyond.y) + int(is_beyond.z) > 1;
  float change = width * (n.x + n.y + n.z - (is_at_edge ? 0.5 : 1.0) * along_axis);
  float c = max(-receiver.plane_distance, length(receiver.p_light) / kMaxPlaneSlope);
  return z_plane / (1.0 + change * z_plane / c);
}

float lit_at_tap(Receiver receiver, vec2 lateral) {
  vec3 direction_world = direction_at(view_light, lateral);
  float along_face = face_distance(direction_world);
  float z_plane = along_face * plane_distance_at(view_light, receiver, lateral);
  float z = nearest_blended_distance(receiver, direction_world / along_face, z_plane) - along_face * receiver.bias_world;
  return texture(shadow_map, vec4(direction_world, depth_of_distance(view_light, z)));
}

float disk_mean(Receiver receiver, float rotation_rad) {
  float radius = radius_texels * texel_lateral(view_light);
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    lit += lit_at_tap(receiver, receiver.lateral + radius * vogel_disk(i, TAPS, rotation_rad));
  }
  return lit / float(TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return disk_mean(receiver, NOISE != 0 ? kTwoPi * interleaved_gradient_noise(noise_position()) : 0.0);
}

void main() {
  Receiver receiver;
  out_visibility = face_pixel() && fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
