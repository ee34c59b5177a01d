// SPDX-License-Identifier: Apache-2.0
// Depth from the cascade that the loop draws.
#include "stored_views.glsl"

layout(location = 0) in vec3 p_world;

void main() {
  LightViewData view = view_of_cascade(layer);
  gl_Position = view.clip_from_light * (view.light_from_world * vec4(p_world, 1.0));
}
