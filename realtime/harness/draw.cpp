// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/draw.h"

namespace umbrameter {

void set_default_state() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  for (const GLenum capability : {GL_CULL_FACE, GL_BLEND, GL_DEPTH_CLAMP, GL_SCISSOR_TEST, GL_DITHER,
                                  GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL}) {
    glDisable(capability);
  }
}

void draw_fullscreen(const VertexArray& empty_vertex_array) {
  glDepthFunc(GL_ALWAYS);  // a disabled test would keep depth from being written
  draw_fullscreen_tested(empty_vertex_array);
  glDepthFunc(GL_GREATER);
}

void draw_fullscreen_tested(const VertexArray& empty_vertex_array) {
  glBindVertexArray(empty_vertex_array.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace umbrameter
