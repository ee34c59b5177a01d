// SPDX-License-Identifier: Apache-2.0
// Cascades: each slice of the camera's frustum has a map of its own (Engel 2006, Zhang et al. 2006). For fullscreen
// passes that read gbuffer.position and gbuffer.normal and see the views `cascade`, in techniques with the parameters of
// the group cascades. The technique says what a map answers: visibility_of().
#define CASCADES view_cascade_count

LightViewData view_of_cascade(int cascade) { return view_cascade[cascade]; }

/// Distances along the camera's axis.
vec2 slice_of_cascade(int cascade) { return view_cascade[cascade].slice_world.xy; }

#include "cascade_choice.glsl"
