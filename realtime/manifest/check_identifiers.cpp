// SPDX-License-Identifier: Apache-2.0
#include "realtime/graph/scene_read.h"
#include "realtime/manifest/check_technique.h"
#include "realtime/manifest/names.h"

#include <fmt/format.h>

#include <map>

namespace umbrameter {
namespace {

/// Identifiers of the shaders' one namespace, with what each stands for.
class Identifiers {
 public:
  void claim(const std::string& identifier, const std::string& what, const FileLocation& where) {
    const auto [taken, is_new] = owners_.emplace(identifier, what);
    if (!is_new)
      fail_input(fmt::format("{} uses the name '{}', which {} has", what, identifier, taken->second), where);
  }

 private:
  std::map<std::string, std::string> owners_;
};

void claim_loops(Identifiers& identifiers, const std::vector<PassDeclaration>& passes) {
  for (const PassDeclaration& pass : passes) {
    if (pass.kind != PassKind::loop) continue;
    const std::string what = fmt::format("loop '{}'", pass.id);
    identifiers.claim(pass.loop_variable, what, pass.where);
    identifiers.claim(pass.loop_variable + "_count", what, pass.where);
    claim_loops(identifiers, pass.body);
  }
}

}  // namespace

void check_identifiers(const Technique& technique) {
  Identifiers identifiers;
  for (const std::string& name : builtin_reads()) identifiers.claim(glsl_name(name), "a built-in", {});
  for (const SceneReadInfo& read : scene_reads()) identifiers.claim(glsl_name(read.name), "a built-in", {});
  identifiers.claim(std::string(kVisibility), "a built-in", {});
  for (const Parameter& parameter : technique.parameters) {
    identifiers.claim(parameter.name, fmt::format("parameter '{}'", parameter.name), parameter.where);
  }
  for (const ResourceDeclaration& resource : technique.resources) {
    const std::string what = fmt::format("resource '{}'", resource.name);
    for (const std::string& name : {resource.name, resource.name + "_size", "out_" + resource.name}) {
      identifiers.claim(name, what, resource.where);
    }
    if (resource.kind == TextureKind::array)
      identifiers.claim(resource.name + "_layers", what, resource.where);
  }
  for (const BufferDeclaration& buffer : technique.buffers) {
    const std::string what = fmt::format("buffer '{}'", buffer.name);
    for (const char* suffix : {"", "_count"}) identifiers.claim(buffer.name + suffix, what, buffer.where);
  }
  if (technique.has_history()) identifiers.claim("history", "a built-in", {});
  for (const std::string& name : read_previously(technique.passes)) {
    const std::string what = fmt::format("the previous '{}'", name);
    for (const char* suffix : {"", "_size", "_layers", "_count"})
      identifiers.claim(glsl_name(kPrevious) + name + suffix, what, {});
  }
  for (const ViewDeclaration& view : technique.views) {
    const std::string what = fmt::format("view '{}'", view.name);
    identifiers.claim("view_" + view.name, what, view.where);
    if (view.is_family()) identifiers.claim(fmt::format("view_{}_count", view.name), what, view.where);
  }
  claim_loops(identifiers, technique.passes);
}

}  // namespace umbrameter
