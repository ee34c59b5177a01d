// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the channels of other renderers' files are called: which layer holds colours, positions, normals, depth. The one list
// of names, of Blender, Mitsuba, V-Ray, Arnold, pbrt, RenderMan, Unreal, Falcor and ours. Not here: pixels
// (lab/pictures/engine_file.h).

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

enum class LayerKind : uint8_t {
  visibility,
  color,  // three or four channels that may be a picture
  grey,   // one channel that may be a picture
  position,
  normal,
  depth,
  primitive_id,
  unshadowed_irradiance,
  other,  // known to be something else: alpha, identifiers, texture coordinates
};

/// Channels that belong together: "ViewLayer.Combined.R", ".G", ".B", ".A" are the layer "ViewLayer.Combined".
struct Layer {
  std::string name;  // empty for R, G, B at the top
  LayerKind kind = LayerKind::other;
  std::vector<std::string>
      channels;                // 3 of a color, position or normal, in the order R, G, B or x, y, z; else 1
  int preference = 0;          // among layers of one kind: the lowest is what a user most likely means
  bool is_known_name = false;  // the kind follows from the name, not from the count of channels alone
};

/// The layers of a file's part whose channels are `names`. Every channel is in one layer, alpha apart.
std::vector<Layer> find_layers(std::span<const std::string> names);

/// The layer that `wanted` names: a channel, or a layer ("ViewLayer.Combined", "Combined"); capitals do not matter. Absent
/// when there is none. A lone channel is `grey`, whatever its name would tell.
std::optional<Layer> layer_called(std::string_view wanted, std::span<const std::string> names);

/// What a file's own name says of its channels, as frame captures have it ("Mogwai.GBufferRaster.posW.0.exr"): position,
/// normal or depth; absent otherwise.
std::optional<LayerKind> kind_of_file_name(std::string_view file);

}  // namespace umbrameter
