// SPDX-License-Identifier: Apache-2.0
#pragma once
// Aligning another engine's picture with the reference: its surfaces where it brought any, and what cannot be known where it
// did not. Not here: its shadows (study/engine_image.h).

#include "core/image.h"
#include "scenes/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// How a depth channel is measured: along the camera's axis, or along the pixel's ray.
enum class DepthKind : uint8_t { axis, ray };

/// Fills `test` with the channels that parity needs: those of `aovs` (position, or depth with a `camera`; normal;
/// primitive_id; unshadowed_irradiance), else the reference's. One sentence for each that was taken from the reference, as
/// whatever it would have told is not known then. Error{input} for other sizes, and for depth without a camera.
std::vector<std::string> add_surfaces(const Image& aovs, const Camera* camera, DepthKind depth_kind,
                                      const Image& reference, Image& test);

/// A mirrored or shifted (2 px) reading of `test` that fits the reference far better than it does as it stands: "upside
/// down", "mirrored", "2 px to the left"; absent when there is none.
std::optional<std::string> better_alignment(const Image& test, const Image& reference);

}  // namespace umbrameter
