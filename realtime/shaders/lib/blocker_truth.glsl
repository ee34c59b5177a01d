// SPDX-License-Identifier: Apache-2.0
// The mean place of what blocks a pixel's rays to the light, as the truth has it instead of a search. Only in pictures that
// ask whether the search is to blame (docs/causes.md): elsewhere nothing of it is compiled.
#include "receiver.glsl"

#ifdef BLOCKER_FROM_TRUTH

/// Along the view's axis; the receiver's own distance where no ray is blocked. Means of places are means of distances
/// along any axis.
float true_blocker_distance(LightViewData view, Receiver receiver) {
  vec3 offset_world = texelFetch(blocker_truth, receiver.px, 0).xyz;
  return receiver.p_light.z + min(0.0, (mat3(view.light_from_world) * offset_world).z);
}

#endif
