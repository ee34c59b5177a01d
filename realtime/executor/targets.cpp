// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/targets.h"

#include "realtime/manifest/names.h"

#include <limits>

namespace umbrameter {
namespace {

glm::vec4 border_color(const std::vector<double>& border) {
  glm::vec4 color(0.0f);
  for (size_t k = 0; k < 4; ++k)
    color[static_cast<int>(k)] = static_cast<float>(border[std::min(k, border.size() - 1)]);
  return color;
}

/// A count that is 1 unless said.
int count(const ResourceDeclaration& resource, const Expression& expression,
          const ExpressionVariables& variables, std::string_view which) {
  constexpr int64_t kMost = 64;
  if (expression.is_empty()) return 1;
  const auto what = fmt::format("{} of resource '{}'", which, resource.name);
  return static_cast<int>(whole_number(expression, variables, 1, kMost, what));
}

int side(const ResourceDeclaration& resource, const Expression& expression,
         const ExpressionVariables& variables, std::string_view which) {
  const auto what = fmt::format("{} of resource '{}'", which, resource.name);
  // The GL's own limit is checked where the texture is made.
  return static_cast<int>(whole_number(expression, variables, 1, std::numeric_limits<int>::max(), what));
}

int layer_count(const ResourceDeclaration& resource, const ExpressionVariables& variables) {
  switch (resource.kind) {
    case TextureKind::flat:
      return 1;
    case TextureKind::array:
      return side(resource, resource.layers, variables, "layers");
    case TextureKind::cube:
      return 6;
  }
  return 1;
}

}  // namespace

Targets::Targets(const RunInputs& inputs, const ExpressionVariables& variables)
    : visibility_(find_texture_format("r32f"), inputs.gbuffer.width(), inputs.gbuffer.height(),
                  std::string(kVisibility)),
      buffers_(inputs, variables) {
  const auto add_screen = [this](const std::string& name, const Texture& texture) {
    targets_[name] = {&texture, Sampler({.wrap = TextureWrap::clamp}), nullptr};
  };
  add_screen(std::string(kVisibility), visibility_);
  add_screen("gbuffer.position", inputs.gbuffer.position);
  add_screen("gbuffer.normal", inputs.gbuffer.normal);
  add_screen("gbuffer.shading_normal", inputs.gbuffer.shading_normal);
  add_screen("gbuffer.primitive_id", inputs.gbuffer.primitive_id);
  add_screen("gbuffer.depth", inputs.gbuffer.depth);
  if (inputs.blue_noise != nullptr)
    targets_[std::string(kBlueNoise)] = {inputs.blue_noise, Sampler({.wrap = TextureWrap::repeat}), nullptr};
  const std::set<std::string> previously = read_previously(inputs.technique.passes);
  for (const ResourceDeclaration& resource : inputs.technique.resources) {
    if (!holds(resource.condition, variables)) continue;
    add_resource(resource, resource.name, variables);
    if (previously.contains(resource.name))
      add_resource(resource, std::string(kPrevious) + resource.name, variables);
  }
  if (!inputs.technique.has_history()) return;
  const GBuffer& before = inputs.previous_gbuffer == nullptr ? inputs.gbuffer : *inputs.previous_gbuffer;
  const std::string previous(kPrevious);
  add_screen(previous + "gbuffer.position", before.position);
  add_screen(previous + "gbuffer.normal", before.normal);
  add_screen(previous + "gbuffer.shading_normal", before.shading_normal);
  add_screen(previous + "gbuffer.primitive_id", before.primitive_id);
  add_screen(previous + "gbuffer.depth", before.depth);
}

void Targets::add_resource(const ResourceDeclaration& resource, const std::string& name,
                           const ExpressionVariables& variables) {
  const TextureFormat& format = find_texture_format(resource.format(variables), resource.where);
  const int width = side(resource, resource.width, variables, "width");
  const int height = side(resource, resource.height, variables, "height");
  const int levels = count(resource, resource.levels, variables, "levels");
  const int samples = count(resource, resource.samples, variables, "samples");
  const int layers = layer_count(resource, variables);
  const FileLocation& where = resource.width.where();
  const auto make = [&](Textures& textures, const TextureShape& shape) {
    auto texture =
        std::make_shared<const Texture>(Texture::declared(format, width, height, name, where, shape));
    return textures.insert_or_assign(name, std::move(texture)).first->second.get();
  };
  Target target;
  const TextureShape drawn{.levels = levels, .samples = samples, .kind = resource.kind, .layers = layers};
  if (samples > 1) target.multisampled = make(multisampled_, drawn);
  const bool is_resolved = samples == 1 || !format.is_depth;  // several depths have no mean
  target.texture =
      is_resolved ? make(owned_, {.levels = levels, .samples = 1, .kind = resource.kind, .layers = layers})
                  : target.multisampled;
  target.sampler = Sampler(
      {.filter = resource.filter,
       .anisotropy = static_cast<double>(count(resource, resource.anisotropy, variables, "anisotropy")),
       .wrap = resource.wrap,
       .border = border_color(resource.border),
       .compare = resource.compare});
  targets_[name] = std::move(target);
}

const Target* Targets::find(const std::string& name) const {
  const auto found = targets_.find(name);
  return found == targets_.end() ? nullptr : &found->second;
}

size_t Targets::declared_bytes() const {
  size_t bytes = buffers_.bytes();
  for (const auto* textures : {&owned_, &multisampled_}) {
    for (const auto& [name, texture] : *textures) bytes += texture->bytes();
  }
  return bytes;
}

void Targets::allocate(const std::string& name) {
  buffers_.allocate(name);
  const auto target = targets_.find(name);
  if (target == targets_.end()) return;
  for (auto* textures : {&owned_, &multisampled_}) {
    const auto found = textures->find(name);
    if (found == textures->end() || found->second->id() != 0) continue;
    const Texture* before = found->second.get();
    auto texture = std::make_shared<const Texture>(before->allocated(name));
    for (const Texture** used : {&target->second.texture, &target->second.multisampled}) {
      if (*used == before) *used = texture.get();
    }
    found->second = std::move(texture);
  }
}

std::shared_ptr<const Texture> Targets::share(const std::string& name) const {
  const auto found = owned_.find(name);
  return found == owned_.end() ? nullptr : found->second;
}

void Targets::replace(const std::string& name, std::shared_ptr<const Texture> texture) {
  targets_.at(name).texture = texture.get();
  owned_.at(name) = std::move(texture);
}

}  // namespace umbrameter
