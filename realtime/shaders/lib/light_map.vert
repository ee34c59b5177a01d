// SPDX-License-Identifier: Apache-2.0
// Depth from a light view. The executor defines VIEW as the view's uniform block instance (view_<name>).
layout(location = 0) in vec3 p_world;

void main() { gl_Position = VIEW.clip_from_light * (VIEW.light_from_world * vec4(p_world, 1.0)); }
