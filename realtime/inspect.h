// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a run of a technique is made of, for people who look into it: what its textures hold, what its shaders say.

#include "core/image.h"
#include "core/renderer.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// A texture of a technique, one layer and level of it.
struct ResourcePart {
  std::string resource;  // as the manifest calls it; gbuffer.* and visibility too
  int layer = 0;         // of an array; of a cube its face, 0 to 5: +x, -x, +y, -y, +z, -z
  int level = 0;
};

/// "shadow_map", "shadow_map:2" or "shadow_map:2:1": name, layer, level. Error{input} otherwise.
ResourcePart parse_resource_part(std::string_view whole);

/// What the texture holds after a frame, row 0 on top: channels R, G, B, A as far as it has them, or Y for a single one.
/// Depth as it is stored: near 1, far 0. Error{input} for a resource that this run does not have, or a layer or level
/// that the resource does not. `renderer` is one of make_realtime_renderer().
Image dump_resource(Renderer& renderer, const Scene& scene, const RenderRequest& request,
                    const ResourcePart& part, Progress& progress);

/// The map of several (cascades, faces of a cube) that each visible point is looked up in, counted from 0; -1 for none.
/// Channel Y; absent for a run that looks into less than two maps.
std::optional<Image> map_indices(Renderer& renderer, const Scene& scene, const RenderRequest& request);

/// Ids of the manifest's passes that a run draws: those whose conditions hold with its parameters.
std::vector<std::string> drawn_passes(Renderer& renderer, const Scene& scene, const RenderRequest& request);

/// Passes so far of untimed frames of a renderer that keeps textures: drawn, and not drawn because a texture of an earlier
/// frame holds what they would draw.
struct PassCounts {
  uint64_t drawn = 0, kept = 0;
};
PassCounts pass_counts(const Renderer& renderer);

/// Buffers of scene data made so far (scene.adjacency, scene.bvh): one a scene, when a pass that reads it is prepared first.
uint64_t scene_data_made(const Renderer& renderer);

/// A shader as it went to the driver, generated prelude and includes in it.
struct FinalShader {
  std::string pass;   // the first pass that uses it
  std::string stage;  // "vertex", "fragment"
  std::string text;
};

/// Those of a run, in the order of its passes.
std::vector<FinalShader> final_shaders(Renderer& renderer, const Scene& scene, const RenderRequest& request);

}  // namespace umbrameter
