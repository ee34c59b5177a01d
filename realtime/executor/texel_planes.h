// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where each visible point falls in the light's map, so that errors can be told by the map's resolution.

#include "core/image.h"
#include "core/parameters.h"
#include "realtime/executor/run_views.h"

#include <span>

namespace umbrameter {

/// Adds texel.x, texel.y and texel_world (core/renderer.h) from `image`'s position and primitive_id. The wider
/// side of a texel counts, as in shaders/lib/spaces.glsl. Of several maps the first that covers the point counts, and
/// none where none does; a single map goes on beyond its border. 0 behind a perspective view's light, too.
void add_texel_planes(std::span<const FittedView> maps, Image& image);

/// The map of several that each visible point is looked up in, as above; -1 for none. Channel Y, of `image`'s size.
Image map_indices(std::span<const FittedView> maps, const Image& image);

/// Adds bias_world, how far a technique moves its comparison towards the light at most, if `parameters` has manual
/// bias_world, bias_texels or normal_offset_texels (techniques/shared/bias_offsets.toml). Needs texel_world.
void add_bias_plane(const ParameterValues& parameters, Image& image);

}  // namespace umbrameter
