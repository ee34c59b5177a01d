// SPDX-License-Identifier: Apache-2.0
// Which triangle the ray through the pixel's centre hits first: the watertight test of Woop, Benthin, Wald,
// "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, section 3.2, with the ray as the z axis.
#include "camera.glsl"
#ifdef HAS_CUTOUTS
#include "cutout.glsl"
#endif

flat in vec3 a_view;
flat in vec3 b_view;
flat in vec3 c_view;
flat in uint triangle;
#ifdef HAS_INSTANCES
flat in uint cutout_record;
#endif

layout(location = 0) out uint out_primitive_id;

// Exactly antisymmetric in its arguments, so that neighbours agree on the edge they share.
float edge(vec2 from, vec2 to) {
  precise float forward = to.x * from.y;
  precise float backward = to.y * from.x;
  precise float twice_area = forward - backward;
  return twice_area;
}

// In double the products are exact: what is 0 now lies on the edge, and is no victim of rounding.
float exact_edge(dvec2 from, dvec2 to) { return float(to.x * from.y - to.y * from.x); }

vec2 sheared(vec3 p_view, vec2 p_ndc) {
  precise vec2 p = p_view.xy - p_ndc * p_view.z;
  return p;
}

void main() {
  vec2 p_ndc = ndc_of_fragment(gl_FragCoord.xy);
  vec2 a = sheared(a_view, p_ndc), b = sheared(b_view, p_ndc), c = sheared(c_view, p_ndc);
  vec3 weights = vec3(edge(b, c), edge(c, a), edge(a, b));
  if (any(equal(weights, vec3(0.0)))) weights = vec3(exact_edge(b, c), exact_edge(c, a), exact_edge(a, b));
  bool is_outside = any(lessThan(weights, vec3(0.0))) && any(greaterThan(weights, vec3(0.0)));
  float sum = weights.x + weights.y + weights.z;
  if (is_outside || sum == 0.0) discard;
  float distance_world = dot(weights, vec3(a_view.z, b_view.z, c_view.z)) / sum;
  if (!(distance_world > forward_world.w)) discard;
#ifdef HAS_CUTOUTS
#ifdef HAS_INSTANCES
  if (cutout_record != 0u && is_hole_of_record(cutout_record, weights / sum)) discard;
#else
  if (is_hole_of(triangle, weights / sum)) discard;
#endif
#endif
  out_primitive_id = triangle;
  gl_FragDepth = forward_world.w / distance_world;
}
