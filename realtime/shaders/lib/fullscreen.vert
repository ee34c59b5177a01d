// SPDX-License-Identifier: Apache-2.0
// One triangle that covers the target; nothing is read.
void main() {
  vec2 p_clip = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(p_clip, 0.0, 1.0);
}
