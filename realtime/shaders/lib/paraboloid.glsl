// SPDX-License-Identifier: Apache-2.0
// Half of all directions in a square: the place d.xy / (1 + d.z) of a unit direction d, in which a paraboloid reflects it (Heidrich
// and Seidel 1998; Brabec et al. 2002). Directions with d.z >= 0 lie in the unit disk.

vec2 paraboloid_place(vec3 direction) { return direction.xy / (1.0 + direction.z); }

/// The unit direction behind a place.
vec3 paraboloid_direction(vec2 place) {
  float squared = dot(place, place);
  return vec3(2.0 * place, 1.0 - squared) / (1.0 + squared);
}
