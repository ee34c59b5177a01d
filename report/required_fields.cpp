// SPDX-License-Identifier: Apache-2.0
#include "report/required_fields.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

bool is_of(const OrderedJson& value, std::string_view type) {
  if (type == "number") return value.is_number();
  if (type == "text") return value.is_string();
  if (type == "flag") return value.is_boolean();
  if (type == "list") return value.is_array();
  UMBRAMETER_ASSERT(type == "object", "no type of a field is called '{}'", type);
  return value.is_object();
}

/// Takes what stands before `mark` off the front of `text`, with the mark; all of it without one.
std::string_view take_until(std::string_view& text, char mark) {
  const size_t at = text.find(mark);
  const std::string_view front = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return front;
}

void require_field(const OrderedJson& value, std::string_view path, std::string_view type,
                   std::string_view field) {
  if (path.empty()) {
    if (!is_of(value, type))
      throw OrderedJson::other_error::create(501, fmt::format("'{}' is none", field), &value);
    return;
  }
  std::string_view name = take_until(path, '.');
  const bool may_be_null = name.ends_with('?');
  if (may_be_null) name.remove_suffix(1);
  const bool is_list = name.ends_with("[]");
  if (is_list) name.remove_suffix(2);
  const OrderedJson& found = value.at(std::string(name));
  if (may_be_null && found.is_null()) return;
  if (!is_list) return require_field(found, path, type, field);
  if (!found.is_array())
    throw OrderedJson::other_error::create(501, fmt::format("'{}' is no list", name), &found);
  for (const OrderedJson& item : found) require_field(item, path, type, field);
}

}  // namespace

void require_fields(const OrderedJson& document, std::span<const std::string_view> fields) {
  for (const std::string_view field : fields) {
    std::string_view type = field;
    const std::string_view path = take_until(type, ':');
    require_field(document, path, type, field);
  }
}

}  // namespace umbrameter
