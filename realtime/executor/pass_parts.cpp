// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/pass_parts.h"

#include "realtime/manifest/names.h"

#include <algorithm>

namespace umbrameter {
namespace {

/// What a pass reads and writes it sees one level below the one it writes.
const Texture* read_texture_of(PreparedPass& prepared, const std::string& name, const Target& target) {
  const std::vector<std::string>& writes = prepared.declaration->writes;
  if (std::ranges::find(writes, name) == writes.end()) return target.texture;
  prepared.level_views.push_back(
      std::make_unique<Texture>(Texture::view_of_level(*target.texture, prepared.place.level - 1)));
  return prepared.level_views.back().get();
}

}  // namespace

const Target& written_target(const PassDeclaration& pass, const std::string& name, const Targets& targets) {
  const Target* target = targets.find(name);
  if (target != nullptr) return *target;
  fail_input(fmt::format("pass '{}' writes '{}', whose condition does not hold", pass.id, name), pass.where,
             "give the pass the same condition");
}

void require_place(const PassDeclaration& pass, const WritePlace& place, const std::string& name,
                   const Texture& texture) {
  if (place.level >= texture.levels()) {
    fail_input(fmt::format("pass '{}' writes level {} of '{}', which has {}", pass.id, place.level, name,
                           texture.levels()),
               pass.where, "give the resource more 'levels'");
  }
  if (texture.kind() != TextureKind::flat && place.layer >= texture.layers()) {
    fail_input(fmt::format("pass '{}' writes layer {} of '{}', which has {}", pass.id, place.layer, name,
                           texture.layers()),
               pass.where, "layers are counted from 0");
  }
}

void require_readable(const PreparedPass& prepared, const Targets& targets) {
  const PassDeclaration& pass = *prepared.declaration;
  for (const std::string& name : pass.reads) {
    const Target* target = targets.find(name);
    if (target == nullptr) continue;
    if (target->texture->samples() > 1)
      fail_input(fmt::format("pass '{}' reads '{}', a multisampled depth", pass.id, name), pass.where);
    if (prepared.place.level > 0 || std::ranges::find(pass.writes, name) == pass.writes.end()) continue;
    fail_input(fmt::format("pass '{}' reads '{}' below level 0", pass.id, name), pass.where,
               "begin with write_level 1");
  }
}

PreludeInputs prelude_inputs(const PassDeclaration& pass, const RunInputs& inputs, const Targets& targets,
                             const PassSurroundings& around) {
  PreludeInputs prelude{inputs.technique, inputs.values, pass, around.loop_variables, around.view_counts, {}};
  prelude.format_of = [&targets](const std::string& name) {
    const Target* target = targets.find(name);
    return target == nullptr ? nullptr : &target->texture->format();
  };
  prelude.buffers = &targets.buffers();
  prelude.takes_blocker_truth = inputs.takes_blocker_truth;
  prelude.scene_has_cutouts = inputs.scene_buffers.cutouts() != nullptr;
  prelude.scene_has_instances = inputs.scene_buffers.instances() != nullptr;
  return prelude;
}

void take_scene_data(PreparedPass& prepared, const RunInputs& inputs) {
  for (const std::string& name : prepared.declaration->reads) {
    if (const SceneReadInfo* read = find_scene_read(name))
      prepared.scene_data.push_back({read->binding, &inputs.scene_data.get(read->read, inputs.scene)});
  }
}

void take_reads(PreparedPass& prepared, const Targets& targets) {
  const PassDeclaration& pass = *prepared.declaration;
  for (size_t unit = 0; unit < pass.reads.size(); ++unit) {
    const Target* target = targets.find(pass.reads[unit]);
    if (target == nullptr) continue;
    prepared.textures.push_back(
        {static_cast<GLuint>(unit), read_texture_of(prepared, pass.reads[unit], *target), &target->sampler});
  }
  for (const BufferSlot& slot : buffer_slots(pass, targets.buffers()))
    prepared.buffers.push_back({slot.binding, targets.buffers().find(slot.name)->buffer.get()});
}

}  // namespace umbrameter
