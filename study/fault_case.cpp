// SPDX-License-Identifier: Apache-2.0
#include "study/fault_case.h"

#include <array>

namespace umbrameter {

std::string_view name_of(FaultOrigin origin) {
  constexpr std::array<std::string_view, 4> kNames = {"technique", "image", "reference", "metric"};
  return kNames[static_cast<size_t>(origin)];
}

}  // namespace umbrameter
