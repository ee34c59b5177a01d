// SPDX-License-Identifier: Apache-2.0
#pragma once
// The two kinds of drawing passes and the fixed-function state all of them start from.

#include "realtime/harness/objects.h"

namespace umbrameter {

/// Depth test GREATER with writes, no culling, no blending, no depth clamp, no scissor, no stencil, no offset, all channels written.
void set_default_state();

/// One triangle over the whole target; lib/fullscreen.vert must be the vertex shader. Depth test off, on
/// again after.
void draw_fullscreen(const VertexArray& empty_vertex_array);
/// The same under the depth test that is set.
void draw_fullscreen_tested(const VertexArray& empty_vertex_array);

}  // namespace umbrameter
