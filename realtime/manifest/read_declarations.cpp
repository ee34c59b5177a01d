// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/manifest_parts.h"
#include "realtime/views/light_view.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

// In the order of their enumerations.
const std::array<std::string, 4> kResourceKinds = {"2d", "array", "cube", "buffer"};
const std::array<std::string, 3> kTextureKinds = {"2d", "array", "cube"};
const std::array<std::string, 3> kFilters = {"nearest", "linear", "mipmap"};
const std::array<std::string, 3> kWraps = {"border", "clamp", "repeat"};
const std::array<std::string, 5> kPassKinds = {"scene", "fullscreen", "mipmap", "loop", "compute"};
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

void read_running(TomlReader& reader, PassDeclaration& pass) {
  pass.once = reader.boolean("once", false);
  if (pass.once && reader.has("timer"))
    reader.fail("timer", "a pass that runs once is not timed", "leave out 'timer'");
  pass.timer = reader.text("timer", "");
}

void read_compute(Manifest& manifest, TomlReader& reader, PassDeclaration& pass, const Names& scope) {
  pass.compute = reader.text("compute");
  pass.groups = read_expressions(manifest, reader, "groups", scope);
  if (pass.groups.empty() || pass.groups.size() > 3)
    reader.fail("groups", fmt::format("'groups' has {} entries", pass.groups.size()),
                "work groups along x, y and z: one to three expressions");
  pass.overwrites = reader.boolean("overwrites", false);
  pass.reads = reader.texts("reads");
  pass.writes = reader.texts("writes");
  pass.views = reader.texts("views");
  if (reader.has("clear")) pass.state.clear = read_numbers(reader, "clear");
  if (pass.overwrites && pass.state.clear)
    reader.fail("clear", fmt::format("pass '{}' clears what its shader overwrites", pass.id),
                "leave out 'clear', or 'overwrites' where the shader does not write all of it");
  pass.write_level = read_expression(manifest, reader, "write_level", scope);
  read_running(reader, pass);
}

void read_drawing(Manifest& manifest, TomlReader& reader, PassDeclaration& pass, const Names& scope) {
  if (pass.kind == PassKind::scene) {
    pass.view = reader.text("view", "");
    pass.view_index = read_expression(manifest, reader, "view_index", scope);
    pass.vertex = reader.text("vertex", "");
    pass.fragment = reader.text("fragment", "");
    pass.vertices = read_expression(manifest, reader, "vertices", scope);
    if (!pass.vertices.is_empty() && pass.vertex.empty())
      reader.fail("vertices",
                  fmt::format("pass '{}' needs a 'vertex' shader that pulls its triangles", pass.id),
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
  pass.state = read_state(manifest, reader, pass.kind == PassKind::scene, scope);
  pass.write_level = read_expression(manifest, reader, "write_level", scope);
  pass.write_layer = read_expression(manifest, reader, "write_layer", scope);
  read_running(reader, pass);
}

}  // namespace

bool is_buffer(const TomlNode& table) {
  return TomlReader(table, "[[resource]]").choice("kind", kResourceKinds, 0) == kTextureKinds.size();
}

BufferDeclaration read_buffer(Manifest& manifest, const TomlNode& table, const Names& scope) {
  TomlReader reader(table, "[[resource]] of a buffer");
  BufferDeclaration buffer;
  buffer.where = table.where;
  buffer.name = read_name(reader, "name");
  reader.require("kind");
  const std::string element = reader.text("element");
  buffer.element = &find_element_type(element, reader.where("element"));
  buffer.count = require_expression(manifest, reader, "count", scope);
  buffer.condition = read_expression(manifest, reader, "condition", scope);
  reader.finish();
  return buffer;
}

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
    case PassKind::compute:
      read_compute(manifest, reader, pass, scope);
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
