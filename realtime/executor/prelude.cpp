// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/prelude.h"

#include "realtime/executor/blocker_truth.h"
#include "realtime/executor/buffer_targets.h"
#include "realtime/graph/scene_read.h"
#include "realtime/harness/frame_uniforms.h"
#include "realtime/harness/objects.h"
#include "realtime/manifest/names.h"

#include <algorithm>
#include <cstring>

namespace umbrameter {
namespace {

std::string glsl_literal(const Parameter& parameter, double value) {
  std::string text = fmt::format("{}", value);
  if (parameter.type == ParameterType::real && text.find_first_of(".e") == std::string::npos) text += ".0";
  return value < 0.0 ? fmt::format("({})", text) : text;
}

std::string defines(const Technique& technique, const ParameterValues& values) {
  std::string text;
  for (const Parameter& parameter : technique.parameters) {
    const std::string macro = macro_name(parameter.name);
    if (parameter.stage == ParameterStage::define) {
      const double value = numeric_value(parameter, values.at(parameter.name));
      text += fmt::format("#define {} {}\n", macro, glsl_literal(parameter, value));
    }
    if (is_switched_to_uniform(values, parameter.name))
      text += fmt::format("#define {} {}\n", macro, parameter.name);
    for (size_t k = 0; k < parameter.choices.size(); ++k) {
      text += fmt::format("#define {}_{} {}\n", macro, macro_name(parameter.choices[k]), k);
    }
  }
  return text;
}

std::string block(std::string_view name, unsigned binding, const std::string& members) {
  if (members.empty()) return {};
  return fmt::format("layout(std140, binding = {}) uniform {} {{ {}}};\n", binding, name, members);
}

std::string uniform_blocks(const PreludeInputs& inputs) {
  std::string parameters;
  for (const Parameter& parameter : inputs.technique.parameters) {
    if (parameter.stage != ParameterStage::uniform) continue;
    parameters +=
        fmt::format("{} {}; ", parameter.type == ParameterType::real ? "float" : "int", parameter.name);
  }
  std::string loops;
  for (const std::string& variable : inputs.loop_variables)
    loops += fmt::format("int {0}; int {0}_count; ", variable);
  const std::string history = inputs.technique.has_history() ? "HistoryData history; " : "";
  return block("ParameterBlock", kParameterBinding, parameters) + block("LoopBlock", kLoopBinding, loops) +
         block("HistoryBlock", kHistoryBinding, history);
}

/// A family is an array and its number of views a macro, but for the one that the pass draws from.
std::string view_blocks(const PreludeInputs& inputs) {
  const PassDeclaration& pass = inputs.pass;
  std::string text;
  unsigned binding = kFirstViewBinding;
  for (const std::string& view : pass_views(pass)) {
    const auto declared = std::ranges::find(inputs.technique.views, view, &ViewDeclaration::name);
    const bool is_array =
        declared != inputs.technique.views.end() && declared->is_family() && view != pass.view;
    const std::string count = is_array ? fmt::format("[{}]", inputs.view_counts.at(view)) : "";
    text +=
        fmt::format("layout(std140, binding = {0}) uniform ViewBlock_{1} {{ LightViewData view_{1}{2}; }};\n",
                    binding++, view, count);
    if (is_array) text += fmt::format("#define view_{}_count {}\n", view, inputs.view_counts.at(view));
  }
  if (!pass.view.empty()) text += fmt::format("#define VIEW view_{}\n", pass.view);
  return text;
}

/// Of this frame or the one before.
const ResourceDeclaration* declared_resource(const Technique& technique, const std::string& read) {
  const std::string_view name = without_previous(read);
  const auto found = std::ranges::find(technique.resources, name, &ResourceDeclaration::name);
  return found == technique.resources.end() ? nullptr : &*found;
}

std::string_view dimensions(TextureKind kind) {
  switch (kind) {
    case TextureKind::flat:
      return "2D";
    case TextureKind::array:
      return "2DArray";
    case TextureKind::cube:
      return "Cube";
  }
  return {};
}

/// "usampler2DArray", "samplerCubeShadow": of a built-in when `resource` is null.
std::string sampler_type(const ResourceDeclaration* resource, const TextureFormat& format) {
  const bool is_compared = resource != nullptr && resource->compare;
  return fmt::format("{}sampler{}{}", format.is_integer ? "u" : "",
                     dimensions(resource == nullptr ? TextureKind::flat : resource->kind),
                     is_compared ? "Shadow" : "");
}

/// The sampler of a resource that this run leaves out is not declared: a shader that reads it does not
/// compile.
std::string samplers(const PreludeInputs& inputs) {
  std::string text;
  for (size_t unit = 0; unit < inputs.pass.reads.size(); ++unit) {
    const std::string& read = inputs.pass.reads[unit];
    const TextureFormat* format = inputs.format_of(read);
    if (format == nullptr) continue;
    const ResourceDeclaration* resource = declared_resource(inputs.technique, read);
    const std::string name = glsl_name(read);
    text += fmt::format("layout(binding = {}) uniform {} {};\n", unit, sampler_type(resource, *format), name);
    text += fmt::format(
        "#define {0}_size vec4(vec2(textureSize({0}, 0).xy), 1.0 / vec2(textureSize({0}, 0).xy))\n", name);
    if (resource != nullptr && resource->kind == TextureKind::array)
      text += fmt::format("#define {0}_layers textureSize({0}, 0).z\n", name);
  }
  return text;
}

/// What a pass reads it cannot change.
std::string buffer_blocks(const PreludeInputs& inputs) {
  std::string text;
  if (inputs.buffers == nullptr) return text;
  for (const BufferSlot& slot : buffer_slots(inputs.pass, *inputs.buffers)) {
    const std::string name = glsl_name(slot.name);
    const std::string_view access = !slot.is_written         ? "readonly "
                                    : inputs.pass.overwrites ? "writeonly "
                                                             : "";
    text += fmt::format("layout(std430, binding = {0}) restrict {1}buffer Buffer_{2} {{ {3} {2}[]; }};\n",
                        slot.binding, access, name, inputs.buffers->find(slot.name)->element->glsl);
    text += fmt::format("#define {0}_count {0}.length()\n", name);
  }
  return text;
}

/// Per `scene.*` a storage block and a macro that tells that it is there.
std::string scene_blocks(const PreludeInputs& inputs) {
  std::string text;
  for (const std::string& name : inputs.pass.reads) {
    const SceneReadInfo* read = find_scene_read(name);
    if (read != nullptr) text += fmt::format("#define HAS_{}\n{}", macro_name(name), read->block);
  }
  if (text.empty()) return text;
  if (inputs.scene_has_cutouts) text += "#define SCENE_HAS_CUTOUTS\n";
  if (inputs.scene_has_instances) text += "#define SCENE_HAS_INSTANCES\n";
  return text;
}

std::string_view output_type(const TextureFormat& format) {
  if (format.is_integer) return format.components == 1 ? "uint" : "uvec2";
  if (format.components == 1) return "float";
  return format.components == 2 ? "vec2" : "vec4";
}

std::string outputs(const PreludeInputs& inputs) {
  std::string text;
  int location = 0;
  for (const std::string& write : inputs.pass.writes) {
    const TextureFormat* format = inputs.format_of(write);
    if (format == nullptr || format->is_depth) continue;
    text += fmt::format("layout(location = {}) out {} out_{};\n", location++, output_type(*format), write);
  }
  return text;
}

/// What a compute pass writes of a texture, all its layers; texels in the resource's own format.
std::string images(const PreludeInputs& inputs) {
  std::string text;
  int unit = 0;
  for (const std::string& write : inputs.pass.writes) {
    const TextureFormat* format = inputs.format_of(write);
    if (format == nullptr) continue;
    const ResourceDeclaration* resource = declared_resource(inputs.technique, write);
    text +=
        fmt::format("layout(binding = {}, {}) uniform restrict {}{}image{} out_{};\n", unit++, format->name,
                    inputs.pass.overwrites ? "writeonly " : "", format->is_integer ? "u" : "",
                    dimensions(resource == nullptr ? TextureKind::flat : resource->kind), write);
  }
  return text;
}

std::string blocker_truth(const PreludeInputs& inputs) {
  if (!inputs.takes_blocker_truth) return {};
  return fmt::format("#define BLOCKER_FROM_TRUTH\nlayout(binding = {}) uniform sampler2D blocker_truth;\n",
                     kBlockerTruthUnit);
}

}  // namespace

std::string vertex_prelude(const PreludeInputs& inputs) {
  return defines(inputs.technique, inputs.values) + std::string(kFrameBlockGlsl) + uniform_blocks(inputs) +
         view_blocks(inputs) + samplers(inputs) + buffer_blocks(inputs) + scene_blocks(inputs);
}

std::string fragment_prelude(const PreludeInputs& inputs) {
  return vertex_prelude(inputs) + outputs(inputs) + blocker_truth(inputs);
}

std::string compute_prelude(const PreludeInputs& inputs) {
  return vertex_prelude(inputs) + images(inputs);
}

std::vector<BufferSlot> buffer_slots(const PassDeclaration& pass, const BufferTargets& buffers) {
  std::vector<BufferSlot> slots;
  unsigned binding = kFirstStorageBinding;
  for (const std::string& name : pass.reads)
    if (const SceneReadInfo* read = find_scene_read(name)) binding = std::max(binding, read->binding + 1);
  for (const std::string& name : pass.reads)
    if (buffers.find(name) != nullptr) slots.push_back({name, binding++, false});
  for (const std::string& name : pass.writes)
    if (buffers.find(name) != nullptr) slots.push_back({name, binding++, true});
  return slots;
}

std::vector<std::string> pass_views(const PassDeclaration& pass) {
  std::vector<std::string> views = pass.views;
  if (!pass.view.empty() && std::ranges::find(views, pass.view) == views.end()) views.push_back(pass.view);
  return views;
}

std::vector<std::byte> parameter_block(const Technique& technique, const ParameterValues& values) {
  std::vector<std::byte> bytes;
  const auto append = [&bytes](const auto& value) {  // std140: scalars follow each other without gaps
    static_assert(sizeof(value) == 4);
    bytes.resize(bytes.size() + sizeof(value));
    std::memcpy(bytes.data() + bytes.size() - sizeof(value), &value, sizeof(value));
  };
  for (const Parameter& parameter : technique.parameters) {
    if (parameter.stage != ParameterStage::uniform) continue;
    const double value = numeric_value(parameter, values.at(parameter.name));
    if (parameter.type == ParameterType::real) {
      append(static_cast<float>(value));
    } else {
      append(static_cast<int32_t>(value));
    }
  }
  return bytes;
}

}  // namespace umbrameter
