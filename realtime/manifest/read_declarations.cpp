#include "realtime/manifest/manifest_parts.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

const std::array<std::string, 2> kFilters = {"nearest", "linear"};
const std::array<std::string, 3> kWraps = {"border", "clamp", "repeat"};
const std::array<std::string, 3> kPassKinds = {"scene", "fullscreen", "loop"};
const std::array<std::string, 3> kCulls = {"none", "back", "front"};
const std::array<std::string, 4> kBlends = {"none", "add", "min", "max"};

/// The expression between the brackets of "light.sample(...)".
ExpressionText sample_expression(const std::string& from, const FileLocation& where) {
  constexpr std::string_view kPrefix = "light.sample(";
  if (from == "light.center") return {};
  if (!from.starts_with(kPrefix) || !from.ends_with(')')) {
    fail_input(fmt::format("a view cannot be from '{}'", from), where,
               "light.center or light.sample(<expression>)");
  }
  return {from.substr(kPrefix.size(), from.size() - kPrefix.size() - 1), where};
}

/// A fit is `visible`, `scene` or a choice parameter with those choices.
void check_fit(Manifest& manifest, const TomlReader& reader, const std::string& fit) {
  if (fit == "visible" || fit == "scene") return;
  for (const Parameter& parameter : manifest.technique.parameters) {
    if (parameter.name != fit) continue;
    const auto is_fit = [](const std::string& choice) { return choice == "visible" || choice == "scene"; };
    if (parameter.type == ParameterType::choice && std::ranges::all_of(parameter.choices, is_fit)) {
      manifest.expression_names.insert(fit);
      return;
    }
    reader.fail("fit", fmt::format("parameter '{}' cannot be a fit", fit),
                "it must be a choice of 'visible' and 'scene'");
  }
  reader.fail("fit", fmt::format("unknown fit '{}'", fit),
              "visible, scene or the name of a choice parameter");
}

PassState read_state(TomlReader& reader) {
  PassState state;
  state.cull = kCulls[reader.choice("cull", kCulls, 0)];
  state.blend = kBlends[reader.choice("blend", kBlends, 0)];
  if (reader.has("clear")) state.clear = read_numbers(reader, "clear");
  state.depth_clamp = reader.boolean("depth_clamp", true);
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

void read_drawing(TomlReader& reader, PassDeclaration& pass) {
  if (pass.kind == "scene") {
    pass.view = reader.text("view", "");
    pass.vertex = reader.text("vertex", "");
    pass.fragment = reader.text("fragment", "");
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
  pass.timer = reader.text("timer", "");
}

}  // namespace

ResourceDeclaration read_resource(Manifest& manifest, const TomlNode& table, const Names& scope) {
  TomlReader reader(table, "[[resource]]");
  ResourceDeclaration resource;
  resource.where = table.where;
  resource.name = read_name(reader, "name");
  resource.format = reader.text("format");
  resource.width = require_expression(manifest, reader, "width", scope);
  resource.height = require_expression(manifest, reader, "height", scope);
  resource.filter = kFilters[reader.choice("filter", kFilters, 0)];
  resource.wrap = kWraps[reader.choice("wrap", kWraps, 0)];
  if (reader.has("border")) resource.border = read_numbers(reader, "border");
  resource.compare = reader.boolean("compare", false);
  resource.condition = read_expression(manifest, reader, "condition", scope).text;
  reader.finish();
  return resource;
}

ViewDeclaration read_view(Manifest& manifest, const TomlNode& table, const Names& scope) {
  TomlReader reader(table, "[[view]]");
  ViewDeclaration view;
  view.where = table.where;
  view.name = read_name(reader, "name");
  view.from = reader.text("from", view.from);
  view.sample = sample_expression(view.from, reader.where("from"));
  if (view.from != "light.center") check_expression(manifest, view.sample, scope);
  view.fit = reader.text("fit", view.fit);
  check_fit(manifest, reader, view.fit);
  view.size = require_expression(manifest, reader, "size", scope).text;
  reader.finish();
  return view;
}

PassDeclaration read_pass(Manifest& manifest, const TomlNode& table, const Names& scope, int depth) {
  TomlReader reader(table, "[[pass]]");
  PassDeclaration pass;
  pass.where = table.where;
  pass.id = reader.text("id");
  pass.kind = kPassKinds[reader.choice("kind", kPassKinds)];
  pass.condition = read_expression(manifest, reader, "condition", scope).text;
  if (pass.kind == "loop") {
    read_loop(manifest, reader, pass, scope, depth);
  } else {
    read_drawing(reader, pass);
  }
  reader.finish();
  return pass;
}

void collect_loop_variables(const std::vector<PassDeclaration>& passes, Names& names) {
  for (const PassDeclaration& pass : passes) {
    if (pass.kind != "loop") continue;
    names.push_back(pass.loop_variable);
    names.push_back(pass.loop_variable + "_count");
    collect_loop_variables(pass.body, names);
  }
}

}  // namespace umbrameter
