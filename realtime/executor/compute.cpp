// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/compute.h"

#include "realtime/executor/pass_parts.h"
#include "realtime/manifest/names.h"

#include <algorithm>

namespace umbrameter {
namespace {

/// That all it writes is there, and with the level that it stores into.
void require_written(const PassDeclaration& pass, const WritePlace& place, const Targets& targets) {
  for (const std::string& name : pass.writes) {
    if (targets.buffers().find(name) != nullptr) continue;
    require_place(pass, place, name, *written_target(pass, name, targets).texture);
  }
}

GLint device_limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// More bindings than the device has are told here: drivers say so in their own words or not at all.
void require_bindings(const PassDeclaration& pass, const Targets& targets) {
  const auto images = std::ranges::count_if(
      pass.writes, [&](const std::string& name) { return targets.find(name) != nullptr; });
  const std::vector<BufferSlot> slots = buffer_slots(pass, targets.buffers());
  const size_t buffers = slots.empty() ? 0 : slots.back().binding + size_t{1};
  const auto require = [&](size_t needed, GLenum limit, std::string_view what) {
    if (needed > static_cast<size_t>(device_limit(limit)))
      fail_input(fmt::format("pass '{}' needs {} bindings of {}", pass.id, needed, what), pass.where,
                 fmt::format("this device has {}", device_limit(limit)));
  };
  require(static_cast<size_t>(images), GL_MAX_COMPUTE_IMAGE_UNIFORMS, "images");
  require(buffers, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, "storage buffers");
}

}  // namespace

PreparedPass prepare_compute(const PassDeclaration& pass, const WritePlace& place, const RunInputs& inputs,
                             const Targets& targets, const PassSurroundings& around, ProgramCache& programs) {
  PreparedPass prepared;
  prepared.declaration = &pass;
  prepared.place = place;
  require_written(pass, place, targets);
  require_readable(prepared, targets);
  require_bindings(pass, targets);
  const auto file = find_shader(pass.compute, inputs.technique.folder, inputs.shaders_folder, pass.where);
  const std::array<ShaderFile, 1> stages = {
      {{ShaderStage::compute, file, compute_prelude(prelude_inputs(pass, inputs, targets, around))}}};
  prepared.program = programs.get(stages);
  label_object(GL_PROGRAM, prepared.program->id(), pass.id);
  return prepared;
}

void attach_compute(PreparedPass& prepared, const Targets& targets) {
  take_reads(prepared, targets);
  GLuint unit = 0;
  for (const std::string& name : prepared.declaration->writes) {
    const Target* target = targets.find(name);
    if (target != nullptr) prepared.images.push_back({unit++, target->texture});
    const BufferTarget* buffer = targets.buffers().find(name);
    if (buffer != nullptr) prepared.written_buffers.push_back(*buffer);
  }
}

std::array<GLuint, 3> group_counts(const PassDeclaration& pass, const ExpressionVariables& variables) {
  constexpr std::string_view kAxes = "xyz";
  std::array<GLuint, 3> counts = {1, 1, 1};
  for (size_t axis = 0; axis < pass.groups.size(); ++axis) {
    GLint limit = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, static_cast<GLuint>(axis), &limit);
    counts.at(axis) =
        static_cast<GLuint>(whole_number(pass.groups[axis], variables, 1, limit,
                                         fmt::format("groups of pass '{}' along {}", pass.id, kAxes[axis])));
  }
  return counts;
}

void clear_written(const PreparedPass& prepared) {
  const auto& values = prepared.declaration->state.clear;
  if (!values) return;
  for (const BoundImage& image : prepared.images) clear_level(*image.texture, prepared.place.level, *values);
  for (const BufferTarget& buffer : prepared.written_buffers) clear_buffer(buffer, *values);
}

void dispatch(const PreparedPass& prepared, const std::array<GLuint, 3>& groups) {
  const GLenum access = prepared.declaration->overwrites ? GL_WRITE_ONLY : GL_READ_WRITE;
  for (const BoundImage& image : prepared.images) {
    const GLboolean has_layers = image.texture->kind() == TextureKind::flat ? GL_FALSE : GL_TRUE;
    glBindImageTexture(image.unit, image.texture->id(), prepared.place.level, has_layers, 0, access,
                       image.texture->format().internal_format);
  }
  glDispatchCompute(groups[0], groups[1], groups[2]);
}

}  // namespace umbrameter
