// SPDX-License-Identifier: Apache-2.0
#include "realtime/graph/buffer.h"

#include "core/names.h"

#include <algorithm>
#include <array>
#include <vector>

namespace umbrameter {

std::span<const ElementType> element_types() {
  using enum ElementScalar;
  static constexpr std::array<ElementType, 10> kTypes = {{{"uint", unsigned_integer, 1},
                                                          {"uvec2", unsigned_integer, 2},
                                                          {"uvec4", unsigned_integer, 4},
                                                          {"int", integer, 1},
                                                          {"ivec2", integer, 2},
                                                          {"ivec4", integer, 4},
                                                          {"float", real, 1},
                                                          {"vec2", real, 2},
                                                          {"vec4", real, 4},
                                                          {"mat4", real, 16}}};
  return kTypes;
}

const ElementType& find_element_type(std::string_view name, const FileLocation& where) {
  const auto types = element_types();
  const auto found = std::ranges::find(types, name, &ElementType::glsl);
  if (found != types.end()) return *found;
  std::vector<std::string> names;
  for (const ElementType& type : types) names.emplace_back(type.glsl);
  fail_input(fmt::format("unknown element type '{}'", name), where, suggest_name(name, names));
}

}  // namespace umbrameter
