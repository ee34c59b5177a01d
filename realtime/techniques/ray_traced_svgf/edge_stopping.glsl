// SPDX-License-Identifier: Apache-2.0
// How much a neighbour counts by its surface (Schied et al. 2017, equations 3 and 4). The change of depth along the receiver's surface is
// that of its plane, where the paper takes differences between pixels.

struct Surface {
  vec3 p_world;
  vec3 n_world;          // geometric
  vec3 n_shading_world;  // interpolated
  float depth;           // distance along the camera's axis; 0 on the background
};

float camera_depth(vec3 p_world) {
  mat4 m = frame.clip_from_world;
  return dot(vec4(m[0].w, m[1].w, m[2].w, m[3].w), vec4(p_world, 1.0));  // const: the four columns
}

Surface surface_at(ivec2 px) {
  vec4 position = texelFetch(gbuffer_position, px, 0);
  vec3 n_shading_world = texelFetch(gbuffer_shading_normal, px, 0).xyz;
  return Surface(position.xyz, texelFetch(gbuffer_normal, px, 0).xyz, n_shading_world,
                 position.w == 0.0 ? 0.0 : camera_depth(position.xyz));
}

/// Depth of the surface's plane where the camera sees `other`.
float plane_depth(Surface surface, Surface other) {
  vec3 eye_world = frame.eye_world.xyz;
  float along = dot(surface.n_world, other.p_world - eye_world);
  if (along == 0.0) return surface.depth;
  return other.depth * dot(surface.n_world, surface.p_world - eye_world) / along;
}

float surface_weight(Surface surface, Surface other) {
  const float kRounding = 1e-5;  // const: of a depth, a hundred roundings: surfaces that face the camera do not change theirs
  if (other.depth == 0.0) return 0.0;
  float change = abs(plane_depth(surface, other) - surface.depth);
  float off = abs(other.depth - surface.depth) / (sigma_depth * change + kRounding * surface.depth);
  float cosine = max(0.0, dot(surface.n_shading_world, other.n_shading_world));
  return exp(-off) * pow(cosine, sigma_normal);
}
