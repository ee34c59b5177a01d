// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/prepare_pass.h"

#include "realtime/executor/compute.h"
#include "realtime/executor/pass_parts.h"
#include "realtime/executor/prelude.h"
#include "realtime/harness/placed_vertices.h"
#include "realtime/manifest/names.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

void require_equal_shapes(const PassDeclaration& pass, const WritePlace& place, const Targets& targets) {
  const Texture& first = written_target(pass, pass.writes.front(), targets).drawn();
  const auto shape = [](const Texture& texture) {
    return fmt::format("{}x{} with {} samples", texture.width(), texture.height(), texture.samples());
  };
  for (const std::string& name : pass.writes) {
    const Texture& texture = written_target(pass, name, targets).drawn();
    require_place(pass, place, name, texture);
    if (shape(texture) == shape(first)) continue;
    fail_input(fmt::format("pass '{}' writes targets of different size: '{}' is {}, '{}' {}", pass.id,
                           pass.writes.front(), shape(first), name, shape(texture)),
               pass.where);
  }
}

void note_formats(PreparedPass& prepared, const PassDeclaration& pass, const Targets& targets) {
  require_equal_shapes(pass, prepared.place, targets);
  for (const std::string& name : pass.writes) {
    const TextureFormat& format = written_target(pass, name, targets).drawn().format();
    if (format.is_depth) {
      prepared.has_depth = true;
    } else {
      prepared.color_formats.push_back(&format);
    }
  }
}

void attach_targets(PreparedPass& prepared, const Targets& targets) {
  const PassDeclaration& pass = *prepared.declaration;
  std::vector<const Texture*> colors;
  const Texture* depth = nullptr;
  for (const std::string& name : pass.writes) {
    const Target& target = written_target(pass, name, targets);
    if (target.drawn().format().is_depth) {
      depth = &target.drawn();
      continue;
    }
    colors.push_back(&target.drawn());
    if (target.multisampled == nullptr) continue;
    const std::array<const Texture*, 1> from = {target.multisampled};
    const std::array<const Texture*, 1> to = {target.texture};
    prepared.resolves.push_back({Framebuffer(from, nullptr), Framebuffer(to, nullptr)});
  }
  prepared.framebuffer = Framebuffer(colors, depth, prepared.place.level, prepared.place.layer);
  label_object(GL_FRAMEBUFFER, prepared.framebuffer.id(), pass.id);
}

std::filesystem::path vertex_file(const PassDeclaration& pass, const RunInputs& inputs) {
  const std::filesystem::path library = inputs.shaders_folder / "lib";
  if (pass.vertex.empty())
    return library / (pass.kind == PassKind::scene ? "light_map.vert" : "fullscreen.vert");
  return find_shader(pass.vertex, inputs.technique.folder, inputs.shaders_folder, pass.where);
}

/// What a program of a scene pass draws.
struct Drawn {
  bool has_holes = false;
  bool are_instances = false;
};

/// Of a pass whose vertices pull their triangle (lib/pulled_triangle.glsl).
std::string pulled_prelude(int vertices, bool has_holes, bool are_instances) {
  return fmt::format("#define VERTICES_PER_TRIANGLE {}\n{}{}", vertices,
                     has_holes ? "#define HAS_CUTOUTS\n" : "",
                     are_instances ? "#define HAS_INSTANCES\n" : "");
}

std::shared_ptr<const Program> compile(const PassDeclaration& pass, const std::filesystem::path& vertex,
                                       const RunInputs& inputs, const Targets& targets,
                                       const PassSurroundings& around, Drawn drawn, ProgramCache& programs) {
  const PreludeInputs prelude = prelude_inputs(pass, inputs, targets, around);
  if (around.vertices > 0) {
    const std::string pulled = pulled_prelude(around.vertices, drawn.has_holes, drawn.are_instances);
    std::vector<ShaderFile> stages = {{ShaderStage::vertex, vertex, vertex_prelude(prelude) + pulled}};
    if (!pass.fragment.empty()) {
      const auto file =
          find_shader(pass.fragment, inputs.technique.folder, inputs.shaders_folder, pass.where);
      stages.push_back({ShaderStage::fragment, file, fragment_prelude(prelude) + pulled});
    }
    return programs.get(stages);
  }
  const std::string vertex_more = drawn.are_instances ? instance_vertex_prelude(drawn.has_holes)
                                  : drawn.has_holes   ? cutout_vertex_prelude()
                                                      : "";
  const std::string fragment_holes = drawn.has_holes ? cutout_fragment_prelude() : "";
  std::vector<ShaderFile> stages = {
      {ShaderStage::vertex, vertex, vertex_prelude(prelude) + vertex_more, drawn.are_instances}};
  if (!pass.fragment.empty() || drawn.has_holes) {
    const auto fragment = pass.fragment.empty() ? inputs.shaders_folder / "lib" / "cutout_depth.frag"
                                                : find_shader(pass.fragment, inputs.technique.folder,
                                                              inputs.shaders_folder, pass.where);
    stages.push_back({ShaderStage::fragment, fragment, fragment_prelude(prelude) + fragment_holes});
  }
  return programs.get(stages);
}

}  // namespace

PreparedPass prepare_pass(const PassDeclaration& pass, const WritePlace& place, const RunInputs& inputs,
                          const Targets& targets, const PassSurroundings& around, ProgramCache& programs) {
  PreparedPass prepared;
  prepared.declaration = &pass;
  prepared.place = place;
  if (pass.kind == PassKind::mipmap) {
    for (const std::string& name : pass.writes) written_target(pass, name, targets);
    return prepared;
  }
  if (pass.kind == PassKind::compute) return prepare_compute(pass, place, inputs, targets, around, programs);
  note_formats(prepared, pass, targets);
  require_readable(prepared, targets);
  const std::filesystem::path vertex = vertex_file(pass, inputs);
  const bool pulls = around.vertices > 0;
  const bool pulls_holes = pulls && inputs.scene_buffers.cutouts() != nullptr;
  prepared.program = compile(pass, vertex, inputs, targets, around, {pulls_holes, false}, programs);
  label_object(GL_PROGRAM, prepared.program->id(), pass.id);
  if (pass.kind == PassKind::scene) {
    const auto compile_for = [&](Drawn drawn) {
      return compile(pass, vertex, inputs, targets, around, drawn, programs);
    };
    const InstanceBuffers* instances = inputs.scene_buffers.instances();
    if (!pulls && inputs.scene_buffers.cutouts() != nullptr)
      prepared.cutout_program = compile_for({true, false});
    if (instances != nullptr) prepared.instance_program = compile_for({pulls_holes, true});
    if (!pulls && instances != nullptr && instances->has_holes())
      prepared.instance_cutout_program = compile_for({true, true});
  }
  prepared.may_cull_casters = pass.kind == PassKind::scene && !pulls &&
                              !prepared.program->names_primitive_id() &&
                              vertex.parent_path() == inputs.shaders_folder / "lib";
  return prepared;
}

void attach_pass(PreparedPass& prepared, const Targets& targets) {
  const PassDeclaration& pass = *prepared.declaration;
  if (pass.kind == PassKind::mipmap) {
    for (const std::string& name : pass.writes)
      prepared.mipmaps.push_back(written_target(pass, name, targets).texture);
    return;
  }
  if (pass.kind == PassKind::compute) return attach_compute(prepared, targets);
  attach_targets(prepared, targets);
  take_reads(prepared, targets);
}

}  // namespace umbrameter
