#include "realtime/executor/prepare_pass.h"

#include "realtime/executor/prelude.h"
#include "realtime/manifest/names.h"

namespace umbrameter {
namespace {

const Texture& written_texture(const PassDeclaration& pass, const std::string& name, const Targets& targets) {
  const Target* target = targets.find(name);
  if (target != nullptr) return *target->texture;
  fail_input(fmt::format("pass '{}' writes '{}', whose condition does not hold", pass.id, name), pass.where,
             "give the pass the same condition");
}

void require_equal_sizes(const PassDeclaration& pass, const Targets& targets) {
  const Texture& first = written_texture(pass, pass.writes.front(), targets);
  for (const std::string& name : pass.writes) {
    const Texture& texture = written_texture(pass, name, targets);
    if (texture.width() == first.width() && texture.height() == first.height()) continue;
    fail_input(fmt::format("pass '{}' writes targets of different size: '{}' is {}x{}, '{}' {}x{}", pass.id,
                           pass.writes.front(), first.width(), first.height(), name, texture.width(),
                           texture.height()),
               pass.where);
  }
}

void attach_targets(PreparedPass& prepared, const PassDeclaration& pass, const Targets& targets) {
  require_equal_sizes(pass, targets);
  std::vector<const Texture*> colors;
  const Texture* depth = nullptr;
  for (const std::string& name : pass.writes) {
    const Texture& texture = written_texture(pass, name, targets);
    if (texture.format().is_depth) {
      depth = &texture;
    } else {
      colors.push_back(&texture);
      prepared.color_formats.push_back(&texture.format());
    }
  }
  prepared.has_depth = depth != nullptr;
  prepared.framebuffer = Framebuffer(colors, depth);
}

std::shared_ptr<const Program> compile(const PassDeclaration& pass, const RunInputs& inputs,
                                       const Targets& targets, std::span<const std::string> loop_variables,
                                       ProgramCache& programs) {
  PreludeInputs prelude{
      inputs.technique, inputs.values, pass, {loop_variables.begin(), loop_variables.end()}, {}};
  prelude.format_of = [&targets](const std::string& name) {
    const Target* target = targets.find(name);
    return target == nullptr ? nullptr : &target->texture->format();
  };
  const auto file = [&](const std::string& name) {
    return find_shader(name, inputs.technique.folder, inputs.shaders_folder, pass.where);
  };
  const std::string standard = pass.kind == "scene" ? "light_map.vert" : "fullscreen.vert";
  const auto vertex = pass.vertex.empty() ? inputs.shaders_folder / "lib" / standard : file(pass.vertex);
  std::vector<ShaderFile> stages = {{ShaderStage::vertex, vertex, vertex_prelude(prelude)}};
  if (!pass.fragment.empty()) {
    stages.push_back({ShaderStage::fragment, file(pass.fragment), fragment_prelude(prelude)});
  }
  return programs.get(stages);
}

}  // namespace

PreparedPass prepare_pass(const PassDeclaration& pass, const RunInputs& inputs, const Targets& targets,
                          std::span<const std::string> loop_variables, ProgramCache& programs) {
  PreparedPass prepared;
  prepared.declaration = &pass;
  attach_targets(prepared, pass, targets);
  for (size_t unit = 0; unit < pass.reads.size(); ++unit) {
    const Target* target = targets.find(pass.reads[unit]);
    if (target != nullptr) prepared.textures.emplace_back(static_cast<GLuint>(unit), target);
  }
  prepared.program = compile(pass, inputs, targets, loop_variables, programs);
  return prepared;
}

}  // namespace umbrameter
