// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which truth a picture is compared with: geometric visibility V, or the irradiance ratio S (docs/metrics.md).

#include "core/image.h"

#include <cstdint>
#include <string_view>

namespace umbrameter {

enum class ShadowQuantity : uint8_t { visibility, irradiance };

/// "visibility" or "irradiance"; Error{input} otherwise.
ShadowQuantity parse_shadow_quantity(std::string_view text);
std::string_view to_text(ShadowQuantity quantity);

/// `reference` with `quantity` where metrics look for visibility, its halves and its standard error. Error{input} for a
/// reference without the channels.
Image with_quantity(Image reference, ShadowQuantity quantity);

}  // namespace umbrameter
