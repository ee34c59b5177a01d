// SPDX-License-Identifier: Apache-2.0
// Fixed-function state of a pass.
#include "core/names.h"
#include "realtime/manifest/manifest_parts.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

// In the order of their enumerations.
const std::array<std::string, 3> kCulls = {"none", "back", "front"};
const std::array<std::string, 4> kBlends = {"none", "add", "min", "max"};
const std::array<std::string, 8> kBlendFactors = {"zero",         "one",
                                                  "source_color", "one_minus_source_color",
                                                  "target_color", "one_minus_target_color",
                                                  "source_alpha", "one_minus_source_alpha"};
const std::array<std::string, 8> kCompareFunctions = {
    "never", "less", "less_or_equal", "equal", "unequal", "greater_or_equal", "greater", "always"};
const std::array<std::string, 8> kStencilActions = {
    "keep", "zero", "replace", "increment", "increment_wrap", "decrement", "decrement_wrap", "invert"};

/// `count` enumerators that a list of texts names; `fallback` when the key is absent.
template <class Enum, size_t count, size_t n>
std::array<Enum, count> read_enums(TomlReader& reader, const std::string& key,
                                   const std::array<std::string, n>& names,
                                   const std::array<Enum, count>& fallback) {
  if (!reader.has(key)) return fallback;
  const std::vector<std::string> texts = reader.texts(key);
  if (texts.size() != count)
    reader.fail(key, fmt::format("'{}' has {} entries", key, texts.size()), fmt::format("{}", count));
  std::array<Enum, count> values{};
  for (size_t i = 0; i < count; ++i) {
    const auto found = std::ranges::find(names, texts[i]);
    if (found == names.end())
      reader.fail(key, fmt::format("unknown name '{}' in '{}'", texts[i], key),
                  suggest_name(texts[i], names));
    values[i] = static_cast<Enum>(found - names.begin());
  }
  return values;
}

int read_stencil_value(TomlReader& reader, const std::string& key, int64_t fallback) {
  const int64_t value = reader.integer(key, fallback);
  if (value < 0 || value > 255)
    reader.fail(key, fmt::format("'{}' = {} is no stencil", key, value), "0 to 255");
  return static_cast<int>(value);
}

StencilState read_stencil(const TomlNode& table) {
  TomlReader reader(table, "[pass.stencil]");
  StencilState stencil;
  constexpr size_t kAlways = 7;
  stencil.test = static_cast<CompareFunction>(reader.choice("test", kCompareFunctions, kAlways));
  stencil.reference = read_stencil_value(reader, "reference", 0);
  stencil.mask = read_stencil_value(reader, "mask", 255);
  using Actions = std::array<StencilAction, 3>;
  const Actions front = read_enums(reader, "front", kStencilActions, Actions{});
  const Actions back = read_enums(reader, "back", kStencilActions, front);
  stencil.front = {front[0], front[1], front[2]};
  stencil.back = {back[0], back[1], back[2]};
  reader.finish();
  return stencil;
}

/// "rg": those channels alone.
std::array<bool, 4> read_channels(TomlReader& reader, const std::string& key) {
  constexpr std::string_view kChannels = "rgba";
  const std::string text = reader.text(key, std::string(kChannels));
  std::array<bool, 4> writes{};
  for (const char channel : text) {
    const size_t k = kChannels.find(channel);
    if (k == std::string_view::npos)
      reader.fail(key, fmt::format("'{}' is no channel", channel), "any of r, g, b, a; \"\" for none");
    writes[k] = true;
  }
  return writes;
}

/// Left, bottom, width and height.
std::array<Expression, 4> read_viewport(Manifest& manifest, TomlReader& reader, const Names& scope) {
  const std::vector<Expression> sides = read_expressions(manifest, reader, "viewport", scope);
  if (sides.size() != 4)
    reader.fail("viewport", fmt::format("'viewport' has {} entries", sides.size()), "[x, y, width, height]");
  return {sides.at(0), sides.at(1), sides.at(2), sides.at(3)};
}

/// Tests, masks and factors beyond culling and blending.
void read_tests(Manifest& manifest, TomlReader& reader, PassState& state, bool is_scene, const Names& scope) {
  state.blend_factors = read_enums(reader, "blend_factors", kBlendFactors, state.blend_factors);
  state.writes_channel = read_channels(reader, "write_channels");
  if (reader.has("depth_test"))
    state.depth_test = static_cast<CompareFunction>(reader.choice("depth_test", kCompareFunctions));
  state.depth_write = reader.boolean("depth_write", true);
  if (reader.has("polygon_offset")) {
    if (!is_scene) reader.fail("polygon_offset", "only scene passes draw what can be offset");
    state.polygon_offset = read_expression_pair(manifest, reader, "polygon_offset", scope);
  }
  if (const TomlNode* stencil = reader.find("stencil")) state.stencil = read_stencil(*stencil);
  if (reader.has("clear_stencil")) state.clear_stencil = read_stencil_value(reader, "clear_stencil", 0);
}

}  // namespace

PassState read_state(Manifest& manifest, TomlReader& reader, bool is_scene, const Names& scope) {
  PassState state;
  state.cull = read_enum<CullMode>(reader, "cull", kCulls);
  state.blend = read_enum<BlendMode>(reader, "blend", kBlends);
  if (reader.has("clear")) state.clear = read_numbers(reader, "clear");
  if (reader.has("viewport")) state.viewport = read_viewport(manifest, reader, scope);
  state.depth_clamp = reader.boolean("depth_clamp", true);
  constexpr int64_t kMaxClipDistances = 8;  // the least a GL offers
  const int64_t clip_distances = reader.integer("clip_distances", 0);
  if (clip_distances < 0 || clip_distances > kMaxClipDistances)
    reader.fail("clip_distances", fmt::format("{} clip distances are not possible", clip_distances),
                "0 to 8");
  state.clip_distances = static_cast<int>(clip_distances);
  read_tests(manifest, reader, state, is_scene, scope);
  return state;
}

}  // namespace umbrameter
