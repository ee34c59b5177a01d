// SPDX-License-Identifier: Apache-2.0
#include "core/names.h"
#include "realtime/manifest/manifest_parts.h"
#include "realtime/views/light_view.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

// In the order of their enumerations.
const std::array<std::string, 3> kTextureKinds = {"2d", "array", "cube"};
const std::array<std::string, 3> kFilters = {"nearest", "linear", "mipmap"};
const std::array<std::string, 3> kWraps = {"border", "clamp", "repeat"};
const std::array<std::string, 4> kPassKinds = {"scene", "fullscreen", "mipmap", "loop"};
const std::array<std::string, 3> kCulls = {"none", "back", "front"};
const std::array<std::string, 4> kBlends = {"none", "add", "min", "max"};
const std::array<std::string, 8> kBlendFactors = {"zero",         "one",
                                                  "source_color", "one_minus_source_color",
                                                  "target_color", "one_minus_target_color",
                                                  "source_alpha", "one_minus_source_alpha"};
const std::array<std::string, 8> kComparisons = {
    "never", "less", "less_or_equal", "equal", "unequal", "greater_or_equal", "greater", "always"};
const std::array<std::string, 8> kStencilActions = {
    "keep", "zero", "replace", "increment", "increment_wrap", "decrement", "decrement_wrap", "invert"};

/// The enumerator that `key` names, the first one when it is absent.
template <class Enum, size_t n>
Enum read_enum(TomlReader& reader, const std::string& key, const std::array<std::string, n>& names) {
  return static_cast<Enum>(reader.choice(key, names, 0));
}

/// "light.center", or one of the others with the expression between its brackets.
void read_origin(Manifest& manifest, TomlReader& reader, ViewDeclaration& view, const Names& scope) {
  const std::string from = reader.text("from", "light.center");
  if (from == "light.center") return;
  for (const auto& [origin, prefix] : {std::pair(ViewOrigin::light_sample, std::string("light.sample(")),
                                       std::pair(ViewOrigin::light_face, std::string("light.face(")),
                                       std::pair(ViewOrigin::light_half, std::string("light.half("))}) {
    if (!from.starts_with(prefix) || !from.ends_with(')')) continue;
    view.from = origin;
    view.index =
        Expression(from.substr(prefix.size(), from.size() - prefix.size() - 1), reader.where("from"));
    check_expression(manifest, view.index, scope);
    return;
  }
  reader.fail("from", fmt::format("a view cannot be from '{}'", from),
              "light.center, light.sample(<expression>), light.face(<expression>) or "
              "light.half(<expression>)");
}

/// A fit is one of light_fits() or a choice parameter among them.
void check_fit(Manifest& manifest, const TomlReader& reader, const std::string& fit) {
  const Names known(light_fits().begin(), light_fits().end());
  const auto is_fit = [&](const std::string& name) { return std::ranges::find(known, name) != known.end(); };
  if (is_fit(fit)) return;
  for (const Parameter& parameter : manifest.technique.parameters) {
    if (parameter.name != fit) continue;
    if (parameter.type == ParameterType::choice && std::ranges::all_of(parameter.choices, is_fit)) {
      manifest.expression_names.insert(fit);
      return;
    }
    reader.fail("fit", fmt::format("parameter '{}' cannot be a fit", fit),
                fmt::format("it must be a choice among {}", fmt::join(known, ", ")));
  }
  reader.fail("fit", fmt::format("unknown fit '{}'", fit),
              fmt::format("{} or the name of a choice parameter", fmt::join(known, ", ")));
}

/// The name of a format, or of a choice parameter among formats.
void read_format(Manifest& manifest, TomlReader& reader, ResourceDeclaration& resource) {
  const std::string format = reader.text("format");
  resource.formats = {format};
  for (const Parameter& parameter : manifest.technique.parameters) {
    if (parameter.name != format) continue;
    if (parameter.type != ParameterType::choice)
      reader.fail("format", fmt::format("parameter '{}' cannot be a format", format),
                  "it must be a choice among formats");
    resource.formats = parameter.choices;
    resource.format_parameter = format;
    manifest.expression_names.insert(format);
  }
}

/// What a face covers is known: a right angle.
void read_coverage(Manifest& manifest, TomlReader& reader, ViewDeclaration& view, const Names& scope) {
  if (view.from == ViewOrigin::light_face || view.from == ViewOrigin::light_half) {
    for (const std::string_view key : {"fit", "snap", "offset_texels", "slice_world"}) {
      if (reader.has(std::string(key)))
        reader.fail(std::string(key), fmt::format("a view all around the light has no '{}'", key),
                    "what it covers is known: leave it out");
    }
    return;
  }
  view.fit = reader.text("fit", view.fit);
  check_fit(manifest, reader, view.fit);
  view.snap = read_expression(manifest, reader, "snap", scope);
  if (reader.has("offset_texels"))
    view.offset_texels = read_expression_pair(manifest, reader, "offset_texels", scope);
  if (!reader.has("slice_world")) return;
  if (view.from != ViewOrigin::light_center)
    reader.fail("slice_world", "only a view from light.center can cover a slice of the frustum");
  view.slice_world = read_expression_pair(manifest, reader, "slice_world", scope);
}

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
      reader.fail(key, fmt::format("unknown name '{}' in '{}'", texts[i], key), suggest_name(texts[i], names));
    values[i] = static_cast<Enum>(found - names.begin());
  }
  return values;
}

int read_stencil_value(TomlReader& reader, const std::string& key, int64_t fallback) {
  const int64_t value = reader.integer(key, fallback);
  if (value < 0 || value > 255) reader.fail(key, fmt::format("'{}' = {} is no stencil", key, value), "0 to 255");
  return static_cast<int>(value);
}

StencilState read_stencil(const TomlNode& table) {
  TomlReader reader(table, "[pass.stencil]");
  StencilState stencil;
  constexpr size_t kAlways = 7;
  stencil.test = static_cast<Comparison>(reader.choice("test", kComparisons, kAlways));
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

/// Tests, masks and factors beyond culling and blending.
void read_tests(Manifest& manifest, TomlReader& reader, PassState& state, bool is_scene, const Names& scope) {
  state.blend_factors = read_enums(reader, "blend_factors", kBlendFactors, state.blend_factors);
  state.writes_channel = read_channels(reader, "write_channels");
  if (reader.has("depth_test"))
    state.depth_test = static_cast<Comparison>(reader.choice("depth_test", kComparisons));
  state.depth_write = reader.boolean("depth_write", true);
  if (reader.has("polygon_offset")) {
    if (!is_scene) reader.fail("polygon_offset", "only scene passes draw what can be offset");
    state.polygon_offset = read_expression_pair(manifest, reader, "polygon_offset", scope);
  }
  if (const TomlNode* stencil = reader.find("stencil")) state.stencil = read_stencil(*stencil);
  if (reader.has("clear_stencil")) state.clear_stencil = read_stencil_value(reader, "clear_stencil", 0);
}

PassState read_state(TomlReader& reader) {
  PassState state;
  state.cull = read_enum<CullMode>(reader, "cull", kCulls);
  state.blend = read_enum<BlendMode>(reader, "blend", kBlends);
  if (reader.has("clear")) state.clear = read_numbers(reader, "clear");
  state.depth_clamp = reader.boolean("depth_clamp", true);
  constexpr int64_t kMaxClipDistances = 8;  // the least a GL offers
  const int64_t clip_distances = reader.integer("clip_distances", 0);
  if (clip_distances < 0 || clip_distances > kMaxClipDistances)
    reader.fail("clip_distances", fmt::format("{} clip distances are not possible", clip_distances),
                "0 to 8");
  state.clip_distances = static_cast<int>(clip_distances);
  return state;
}

void read_loop(Manifest& manifest, TomlReader& reader, PassDeclaration& pass, Names scope, int depth) {
  constexpr int kMaxLoopDepth = 4;
  if (depth >= kMaxLoopDepth) reader.fail("kind", fmt::format("more than {} nested loops", kMaxLoopDepth));
  pass.loop_variable = read_name(reader, "variable");
  pass.loop_count = require_expression(manifest, reader, "count", scope);
  scope.push_back(pass.loop_variable);
  scope.push_back(pass.loop_variable + "_count");
  for (const TomlNode* body : reader.tables("pass")) {
    pass.body.push_back(read_pass(manifest, *body, scope, depth + 1));
  }
  if (pass.body.empty()) reader.fail("kind", "a loop needs at least one [[pass.pass]]");
}

void read_drawing(Manifest& manifest, TomlReader& reader, PassDeclaration& pass, const Names& scope) {
  if (pass.kind == PassKind::scene) {
    pass.view = reader.text("view", "");
    pass.view_index = read_expression(manifest, reader, "view_index", scope);
    pass.vertex = reader.text("vertex", "");
    pass.fragment = reader.text("fragment", "");
    pass.vertices = read_expression(manifest, reader, "vertices", scope);
    if (!pass.vertices.is_empty() && pass.vertex.empty())
      reader.fail("vertices", fmt::format("pass '{}' needs a 'vertex' shader that pulls its triangles", pass.id),
                  "include \"pulled_triangle.glsl\" in one");
    if (pass.view.empty() && pass.vertex.empty()) {
      reader.fail("kind", fmt::format("pass '{}' needs a 'view' or a 'vertex' shader of its own", pass.id));
    }
  } else {
    pass.fragment = reader.text("fragment");
  }
  pass.reads = reader.texts("reads");
  pass.writes = reader.texts("writes");
  pass.views = reader.texts("views");
  pass.state = read_state(reader);
  read_tests(manifest, reader, pass.state, pass.kind == PassKind::scene, scope);
  pass.write_level = read_expression(manifest, reader, "write_level", scope);
  pass.write_layer = read_expression(manifest, reader, "write_layer", scope);
  pass.once = reader.boolean("once", false);
  if (pass.once && reader.has("timer"))
    reader.fail("timer", "a pass that runs once is not timed", "leave out 'timer'");
  pass.timer = reader.text("timer", "");
}

}  // namespace

ResourceDeclaration read_resource(Manifest& manifest, const TomlNode& table, const Names& scope) {
  TomlReader reader(table, "[[resource]]");
  ResourceDeclaration resource;
  resource.where = table.where;
  resource.name = read_name(reader, "name");
  read_format(manifest, reader, resource);
  resource.kind = read_enum<TextureKind>(reader, "kind", kTextureKinds);
  resource.width = require_expression(manifest, reader, "width", scope);
  resource.height = require_expression(manifest, reader, "height", scope);
  if (resource.kind == TextureKind::array) {
    resource.layers = require_expression(manifest, reader, "layers", scope);
  } else if (reader.has("layers")) {
    reader.fail("layers", "only kind = \"array\" has 'layers'", "a cube has six");
  }
  resource.levels = read_expression(manifest, reader, "levels", scope);
  resource.samples = read_expression(manifest, reader, "samples", scope);
  resource.anisotropy = read_expression(manifest, reader, "anisotropy", scope);
  resource.filter = read_enum<TextureFilter>(reader, "filter", kFilters);
  resource.wrap = read_enum<TextureWrap>(reader, "wrap", kWraps);
  if (reader.has("border")) resource.border = read_numbers(reader, "border");
  resource.compare = reader.boolean("compare", false);
  resource.condition = read_expression(manifest, reader, "condition", scope);
  reader.finish();
  return resource;
}

ViewDeclaration read_view(Manifest& manifest, const TomlNode& table, const Names& scope,
                          const Names& family_scope) {
  TomlReader reader(table, "[[view]]");
  ViewDeclaration view;
  view.where = table.where;
  view.name = read_name(reader, "name");
  Names inner = scope;
  if (reader.has("count")) {
    inner = family_scope;
    view.count = read_expression(manifest, reader, "count", inner);
    view.variable = read_name(reader, "variable");
    if (std::ranges::find(inner, view.variable) != inner.end())
      reader.fail("variable", fmt::format("'{}' means something else already", view.variable));
    inner.push_back(view.variable);
  }
  read_origin(manifest, reader, view, inner);
  read_coverage(manifest, reader, view, inner);
  view.size = require_expression(manifest, reader, "size", inner);
  reader.finish();
  return view;
}

PassDeclaration read_pass(Manifest& manifest, const TomlNode& table, const Names& scope, int depth) {
  TomlReader reader(table, "[[pass]]");
  PassDeclaration pass;
  pass.where = table.where;
  pass.id = reader.text("id");
  pass.kind = static_cast<PassKind>(reader.choice("kind", kPassKinds));
  pass.condition = read_expression(manifest, reader, "condition", scope);
  switch (pass.kind) {
    case PassKind::loop:
      read_loop(manifest, reader, pass, scope, depth);
      break;
    case PassKind::mipmap:
      pass.writes = reader.texts("writes");
      pass.timer = reader.text("timer", "");
      break;
    case PassKind::scene:
    case PassKind::fullscreen:
      read_drawing(manifest, reader, pass, scope);
      break;
  }
  reader.finish();
  return pass;
}

void collect_loop_variables(const std::vector<PassDeclaration>& passes, Names& names) {
  for (const PassDeclaration& pass : passes) {
    if (pass.kind != PassKind::loop) continue;
    names.push_back(pass.loop_variable);
    names.push_back(pass.loop_variable + "_count");
    collect_loop_variables(pass.body, names);
  }
}

}  // namespace umbrameter
