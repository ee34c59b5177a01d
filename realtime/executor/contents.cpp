// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/contents.h"

#include "core/hash.h"
#include "realtime/executor/prelude.h"
#include "realtime/harness/frame_uniforms.h"
#include "realtime/manifest/names.h"

#include <algorithm>

namespace umbrameter {
namespace {

void hash_state(Hasher& hasher, const PassDeclaration& pass, const WritePlace& place) {
  const PassState& state = pass.state;
  hasher.number(static_cast<double>(pass.kind)).number(static_cast<double>(state.cull));
  hasher.number(static_cast<double>(state.blend)).number(state.depth_clamp ? 1.0 : 0.0);
  hasher.number(state.clip_distances).number(state.clear ? 1.0 : 0.0);
  if (state.clear) hasher.number(static_cast<double>(state.clear->size())).values(std::span(*state.clear));
  hasher.number(place.level).number(place.layer).number(pass.overwrites ? 1.0 : 0.0);
  for (const BlendFactor factor : state.blend_factors) hasher.number(static_cast<double>(factor));
  for (const bool writes : state.writes_channel) hasher.number(writes ? 1.0 : 0.0);
  hasher.number(state.depth_test ? static_cast<double>(*state.depth_test) : -1.0);
  hasher.number(state.depth_write ? 1.0 : 0.0).number(state.clear_stencil.value_or(-1));
  hasher.number(state.stencil ? 1.0 : 0.0);
  if (!state.stencil) return;
  hasher.number(static_cast<double>(state.stencil->test)).number(state.stencil->reference);
  hasher.number(state.stencil->mask);
  for (const StencilFace& face : {state.stencil->front, state.stencil->back})
    for (const StencilAction action : {face.fail, face.depth_fail, face.pass})
      hasher.number(static_cast<double>(action));
}

void hash_shape(Hasher& hasher, const Texture& texture) {
  hasher.text(texture.format().name).number(texture.width()).number(texture.height());
  hasher.number(texture.levels()).number(texture.samples()).number(texture.layers());
  hasher.number(static_cast<double>(texture.kind()));
}

void hash_sampler(Hasher& hasher, const SamplerSettings& settings) {
  hasher.number(static_cast<double>(settings.filter)).number(static_cast<double>(settings.wrap));
  hasher.number(settings.anisotropy).number(settings.compare ? 1.0 : 0.0);
  for (int k = 0; k < 4; ++k) hasher.number(static_cast<double>(settings.border[k]));
}

class Contents {
 public:
  Contents(const Plan& plan, const RunInputs& inputs, const std::string& picture_key)
      : plan_(plan), inputs_(inputs), picture_key_(picture_key) {
    for (const std::string& name : builtin_reads()) now_[name] = picture_key;
    declare(std::string(kVisibility));
    for (const ResourceDeclaration& resource : inputs.technique.resources) declare(resource.name);
    for (const BufferDeclaration& buffer : inputs.technique.buffers) declare_buffer(buffer.name);
  }

  RunContents find() {
    for (const bool once : {true, false}) {  // the first frame draws these first
      for (size_t i = 0; i < plan_.steps.size(); ++i) {
        if (plan_.steps[i].once == once) add(i);
      }
    }
    return std::move(found_);
  }

 private:
  /// Nothing has been drawn into it yet.
  void declare(const std::string& name) {
    const Target* target = plan_.targets->find(name);
    if (target == nullptr) return;
    Hasher hasher;
    hash_shape(hasher, *target->texture);
    hash_shape(hasher, target->drawn());
    now_[name] = hasher.hex();
  }

  void declare_buffer(const std::string& name) {
    const BufferTarget* target = plan_.targets->buffers().find(name);
    if (target == nullptr) return;
    now_[name] = Hasher().text(target->element->glsl).number(static_cast<double>(target->count)).hex();
  }

  /// Empty for what is neither a resource of the technique nor known to be the picture's.
  std::string content_of(const std::string& name) const {
    const auto found = now_.find(name);
    return found == now_.end() ? std::string() : found->second;
  }

  void add(size_t index) {
    const Step& step = plan_.steps[index];
    const PassDeclaration& pass = *plan_.passes[step.pass].declaration;
    StepUse use{index, {}, {}};
    for (const std::string& name : pass.reads) {
      if (plan_.targets->has(name)) use.reads.push_back({name, content_of(name)});
    }
    for (const std::string& name : pass.writes) use.writes.push_back({name, content_of(name)});
    const std::string key = key_of(step, use);
    for (const TextureUse& written : use.writes)
      found_.last[written.name] = now_[written.name] =
          key.empty() ? key : Hasher().text(key).text(written.name).hex();
    found_.steps.push_back(std::move(use));
  }

  std::string key_of(const Step& step, const StepUse& use) const {
    const PreparedPass& pass = plan_.passes[step.pass];
    Hasher hasher;
    hasher.text(picture_key_);
    hash_state(hasher, *pass.declaration, pass.place);
    hasher.number(step.polygon_offset[0]).number(step.polygon_offset[1]).number(step.vertices);
    if (step.viewport) {
      const Viewport& part = *step.viewport;
      hasher.number(part.x).number(part.y).number(part.width).number(part.height);
    }
    for (const GLuint groups : step.groups) hasher.number(groups);
    for (const auto& program : {pass.program, pass.cutout_program}) {
      if (program == nullptr) continue;
      if (!knows_samplers(*program, *pass.declaration)) return {};
      hasher.text(program->key());
      hash_parameters(hasher, *program);
    }
    hash_range(hasher, plan_.frame_uniforms.front());
    for (const auto& program : {pass.program, pass.cutout_program}) {
      if (program != nullptr && plan_.history_uniforms && program->reads_uniform("history"))
        hash_range(hasher, *plan_.history_uniforms);
    }
    for (const UniformRange& range : step.uniforms) hash_range(hasher, range);
    for (const auto* textures : {&use.reads, &use.writes}) {
      hasher.number(static_cast<double>(textures->size()));
      for (const TextureUse& texture : *textures) {
        if (texture.content.empty()) return {};
        hasher.text(texture.name).text(texture.content);
      }
    }
    for (const TextureUse& read : use.reads) {
      const Target* texture = plan_.targets->find(read.name);
      if (texture != nullptr) hash_sampler(hasher, texture->sampler.settings());
    }
    return hasher.hex();
  }

  /// Whether all that it samples or stores into is declared: of what else is bound nobody knows where it comes from.
  static bool knows_samplers(const Program& program, const PassDeclaration& pass) {
    return std::ranges::all_of(program.samplers(), [&](const std::string& sampler) {
      const auto is_image = [&](const std::string& write) { return sampler == "out_" + write; };
      return std::ranges::find(pass.reads, sampler, glsl_name) != pass.reads.end() ||
             (pass.kind == PassKind::compute && std::ranges::any_of(pass.writes, is_image));
    });
  }

  void hash_range(Hasher& hasher, const UniformRange& range) const {
    hasher.number(range.binding);
    hasher.values(std::span(plan_.uniform_bytes)
                      .subspan(static_cast<size_t>(range.offset), static_cast<size_t>(range.bytes)));
  }

  /// Of the block's members only those that the shader names: one that it does not changes nothing.
  void hash_parameters(Hasher& hasher, const Program& program) const {
    for (const Parameter& parameter : inputs_.technique.parameters) {
      if (parameter.stage != ParameterStage::uniform || !program.reads_uniform(parameter.name)) continue;
      hasher.text(parameter.name).number(numeric_value(parameter, inputs_.values.at(parameter.name)));
    }
  }

  const Plan& plan_;
  const RunInputs& inputs_;
  const std::string& picture_key_;
  std::map<std::string, std::string> now_;
  RunContents found_;
};

}  // namespace

RunContents find_contents(const Plan& plan, const RunInputs& inputs, const std::string& picture_key) {
  return Contents(plan, inputs, picture_key).find();
}

}  // namespace umbrameter
