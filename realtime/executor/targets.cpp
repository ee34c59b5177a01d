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

int side(const ResourceDeclaration& resource, const ExpressionText& expression,
         const ExpressionVariables& variables, std::string_view which) {
  const auto what = fmt::format("{} of resource '{}'", which, resource.name);
  // The GL's own limit is checked where the texture is made.
  return static_cast<int>(whole_number(expression, variables, 1, std::numeric_limits<int>::max(), what));
}

}  // namespace

Targets::Targets(const RunInputs& inputs, const ExpressionVariables& variables)
    : visibility_(find_texture_format("r32f"), inputs.gbuffer.width(), inputs.gbuffer.height(),
                  std::string(kVisibility)) {
  const auto add_screen = [this](const std::string& name, const Texture& texture) {
    targets_[name] = {&texture, Sampler({.linear = false, .wrap = "clamp"})};
  };
  add_screen(std::string(kVisibility), visibility_);
  add_screen("gbuffer.position", inputs.gbuffer.position);
  add_screen("gbuffer.normal", inputs.gbuffer.normal);
  add_screen("gbuffer.shading_normal", inputs.gbuffer.shading_normal);
  add_screen("gbuffer.primitive_id", inputs.gbuffer.primitive_id);
  for (const ResourceDeclaration& resource : inputs.technique.resources) {
    if (holds(resource.condition, variables, resource.where)) add_resource(resource, variables);
  }
}

void Targets::add_resource(const ResourceDeclaration& resource, const ExpressionVariables& variables) {
  const TextureFormat& format = find_texture_format(resource.format, resource.where);
  const int width = side(resource, resource.width, variables, "width");
  const int height = side(resource, resource.height, variables, "height");
  const auto [owned, is_new] =
      owned_.emplace(resource.name, Texture(format, width, height, resource.name, resource.width.where));
  UMBRAMETER_ASSERT(is_new, "resource {}", resource.name);
  targets_[resource.name] = {&owned->second, Sampler({.linear = resource.filter == "linear",
                                                      .wrap = resource.wrap,
                                                      .border = border_color(resource.border),
                                                      .compare = resource.compare})};
}

const Target* Targets::find(const std::string& name) const {
  const auto found = targets_.find(name);
  return found == targets_.end() ? nullptr : &found->second;
}

size_t Targets::declared_bytes() const {
  size_t bytes = 0;
  for (const auto& [name, texture] : owned_) bytes += texture.bytes();
  return bytes;
}

}  // namespace umbrameter
