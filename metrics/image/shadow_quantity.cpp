// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/shadow_quantity.h"

#include "core/error.h"
#include "core/names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace umbrameter {
namespace {

constexpr const char* kQuantityKey = "quantity";
constexpr std::array<const char*, 2> kQuantityNames = {"visibility", "irradiance"};
constexpr std::array<std::pair<const char*, const char*>, 4> kIrradiance = {
    {{"irradiance_ratio", "visibility"},
     {"irradiance_ratio_se", "visibility_se"},
     {"irradiance_half_a", "half_a"},
     {"irradiance_half_b", "half_b"}}};

}  // namespace

ShadowQuantity parse_shadow_quantity(std::string_view text) {
  const auto found = std::ranges::find(kQuantityNames, text);
  if (found != kQuantityNames.end()) return static_cast<ShadowQuantity>(found - kQuantityNames.begin());
  const std::vector<std::string> known(kQuantityNames.begin(), kQuantityNames.end());
  fail_input(fmt::format("unknown quantity '{}'", text), {}, suggest_name(std::string(text), known));
}

std::string_view to_text(ShadowQuantity quantity) {
  return kQuantityNames[static_cast<size_t>(quantity)];
}

ShadowQuantity quantity_of(const Image& picture) {
  const auto found = picture.metadata.find(kQuantityKey);
  return found == picture.metadata.end() ? ShadowQuantity::visibility : parse_shadow_quantity(found->second);
}

const Image& truth_for(const Image& picture, const Image& reference, std::optional<Image>& made) {
  const ShadowQuantity quantity = quantity_of(picture);
  if (quantity == ShadowQuantity::visibility) return reference;
  return made.emplace(with_quantity(reference, quantity));
}

Image with_quantity(Image reference, ShadowQuantity quantity) {
  if (quantity == ShadowQuantity::visibility) return reference;
  for (const auto& [from, to] : kIrradiance) {
    if (!reference.has(from))
      fail_input(fmt::format("the reference has no channel '{}'", from), {},
                 "make it anew with 'umbrameter reference'");
    const auto plane = reference.plane(from);
    reference.planes[to].assign(plane.begin(), plane.end());
  }
  return reference;
}

}  // namespace umbrameter
