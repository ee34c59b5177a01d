// SPDX-License-Identifier: Apache-2.0
#pragma once
// Frames and truths as pictures of the window. The colours of error, faults and background are results/pictures/pictures.h's.

#include "core/image.h"
#include "metrics/faults/faults.h"
#include "results/pictures/pictures.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace umbrameter {

enum class Layer : uint8_t { lit, visibility, error, faults, standard_error, normals, irradiance, maps };
inline constexpr size_t kLayers = 8;
std::string_view title_of(Layer layer);

/// Whether the layer is of a technique's picture and the truth together.
bool needs_truth(Layer layer);

struct PaintSettings {
  double exposure_stops = 0.0;
  double white_irradiance = 1.0;  // drawn nearly white at exposure 0 when fully lit
  double error_scale = kSignedErrorScale;
  bool has_edges = false;  // of the visible triangles, over the picture
};

/// What a pane is painted from. `image` is a technique's frame or a truth.
struct PaintInputs {
  const Image& image;
  const Image* truth = nullptr;        // of the same size; absent: nothing to compare with yet
  std::span<const uint8_t> scored;     // with `truth`: empty = not known yet, all surfaces count
  std::span<const FaultClass> faults;  // empty = not told apart yet
  const Image* maps = nullptr;         // of map_indices() (realtime/inspect.h), of the same size
};

/// What `layer` shows. Where something is missing (no truth, no faults yet) the lit picture, pale.
Picture paint(Layer layer, const PaintInputs& inputs, const PaintSettings& settings);

/// Of a cascade or a face of a cube, by its number; they repeat after eight. Okabe and Ito's, which colour-blind people
/// can tell apart.
const Rgb8& map_colour(size_t map);

/// The 98th percentile of unshadowed irradiance over lit surfaces; 1 where nothing is lit.
double white_irradiance(const Image& image);

/// A texture's channels as colours: from its least to its greatest value, black to white; not finite: magenta.
struct ResourcePicture {
  Picture picture;
  double min = 0.0, max = 0.0;
};
ResourcePicture paint_resource(const Image& resource);

}  // namespace umbrameter
