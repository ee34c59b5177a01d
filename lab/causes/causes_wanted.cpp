// SPDX-License-Identifier: Apache-2.0
#include "lab/causes/causes_wanted.h"

#include "core/error.h"
#include "core/names.h"

#include <algorithm>
#include <array>
#include <string>

namespace umbrameter {

CausesWanted choose_causes(std::string_view text) {
  static const std::array<std::string, 4> kNames = {"none", "auto", "worst", "all"};
  const auto found = std::ranges::find(kNames, text);
  if (found == kNames.end())
    fail_input(fmt::format("'{}' says not of which runs causes are looked for", text), {},
               suggest_name(text, kNames));
  return static_cast<CausesWanted>(found - kNames.begin());
}

}  // namespace umbrameter
