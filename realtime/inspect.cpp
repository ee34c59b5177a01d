// SPDX-License-Identifier: Apache-2.0
#include "realtime/inspect.h"

#include "core/error.h"

#include <array>
#include <charconv>

namespace umbrameter {

ResourcePart parse_resource_part(std::string_view whole) {
  const auto fail = [&] {
    fail_input(fmt::format("'{}' names no part of a resource", whole), {},
               "RESOURCE, RESOURCE:LAYER or RESOURCE:LAYER:LEVEL, counted from 0");
  };
  ResourcePart part;
  std::string_view text = whole;
  const std::array<int*, 2> numbers = {&part.layer, &part.level};
  size_t end = text.find(':');
  part.resource = text.substr(0, end);
  if (part.resource.empty()) fail();
  for (int* number : numbers) {
    if (end == std::string_view::npos) return part;
    text.remove_prefix(end + 1);
    end = text.find(':');
    const std::string_view digits = text.substr(0, end);
    const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), *number);
    if (error != std::errc{} || rest != digits.data() + digits.size() || *number < 0) fail();
  }
  if (end != std::string_view::npos) fail();
  return part;
}

}  // namespace umbrameter
