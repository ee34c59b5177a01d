// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which truth a picture is compared with: geometric visibility V, or the irradiance ratio S (docs/metrics.md).

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace umbrameter {

enum class ShadowQuantity : uint8_t { visibility, irradiance };

/// "visibility" or "irradiance"; Error{input} otherwise.
ShadowQuantity parse_shadow_quantity(std::string_view text);
std::string_view to_text(ShadowQuantity quantity);

/// What a run's picture says that it is; visibility unless its metadata have another "quantity".
ShadowQuantity quantity_of(const Image& picture);

/// `reference` with `quantity` where metrics look for visibility, its halves and its standard error. Error{input} for a
/// reference without the channels.
Image with_quantity(Image reference, ShadowQuantity quantity);

/// The truth that `picture` is compared with: `reference` itself, or what with_quantity() makes of it, which `made` keeps.
const Image& truth_for(const Image& picture, const Image& reference, std::optional<Image>& made);

}  // namespace umbrameter
