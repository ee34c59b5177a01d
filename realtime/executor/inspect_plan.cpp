// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/inspect_plan.h"

#include "core/names.h"
#include "realtime/harness/readback.h"
#include "realtime/manifest/names.h"

#include <algorithm>

namespace umbrameter {
namespace {

[[noreturn]] void fail_unknown(const Technique& technique, const std::string& resource) {
  std::vector<std::string> known(builtin_reads().begin(), builtin_reads().end());
  known.emplace_back(kVisibility);
  for (const ResourceDeclaration& declared : technique.resources) known.push_back(declared.name);
  for (const BufferDeclaration& declared : technique.buffers) known.push_back(declared.name);
  if (std::ranges::find(known, resource) == known.end()) {
    fail_input(fmt::format("technique '{}' has no texture or buffer '{}'", technique.id, resource), {},
               suggest_name(resource, known));
  }
  fail_input(fmt::format("technique '{}' has no texture '{}' with these parameters", technique.id, resource),
             {}, "its condition does not hold");
}

Image read_buffer_part(const BufferTarget& target, const ResourcePart& part) {
  if (part.layer != 0 || part.level != 0)
    fail_input(
        fmt::format("buffer '{}' has no layer {} with a level {}", part.resource, part.layer, part.level), {},
        "name it alone: a buffer has neither layers nor levels");
  return read_elements(target);
}

const Texture& find_part(const Technique& technique, const Targets& targets, const ResourcePart& part) {
  const Target* target = targets.find(part.resource);
  if (target == nullptr) fail_unknown(technique, part.resource);
  const Texture& texture = *target->texture;
  if (texture.samples() > 1)
    fail_input(fmt::format("texture '{}' is a multisampled depth, which cannot be read", part.resource));
  if (part.layer >= 0 && part.layer < texture.layers() && part.level >= 0 && part.level < texture.levels())
    return texture;
  fail_input(
      fmt::format("texture '{}' has no layer {} with a level {}", part.resource, part.layer, part.level), {},
      fmt::format("layers 0 to {}, levels 0 to {}", texture.layers() - 1, texture.levels() - 1));
}

}  // namespace

Image read_part(const Technique& technique, Targets& targets, const ResourcePart& part) {
  targets.allocate(part.resource);
  if (const BufferTarget* buffer = targets.buffers().find(part.resource))
    return read_buffer_part(*buffer, part);
  return read_layer(find_part(technique, targets, part), part.layer, part.level);
}

std::vector<std::string> drawn_passes(const Plan& plan) {
  std::vector<std::string> ids;
  for (const PreparedPass& pass : plan.passes)
    if (std::ranges::find(ids, pass.declaration->id) == ids.end()) ids.push_back(pass.declaration->id);
  return ids;
}

std::vector<FinalShader> final_shaders(const Plan& plan) {
  std::vector<FinalShader> found;
  for (const PreparedPass& pass : plan.passes) {
    if (pass.program == nullptr) continue;
    for (const StageText& stage : pass.program->texts()) {
      if (std::ranges::find(found, stage.text, &FinalShader::text) != found.end()) continue;
      found.push_back({pass.declaration->id, std::string(to_text(stage.stage)), stage.text});
    }
  }
  return found;
}

}  // namespace umbrameter
