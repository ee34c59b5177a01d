// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/left_out.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;

void add_passes(const std::vector<PassDeclaration>& passes, const Plan& plan,
                std::vector<std::string>& names) {
  for (const PassDeclaration& pass : passes) {
    if (pass.kind == PassKind::loop) {
      add_passes(pass.body, plan, names);
      continue;
    }
    const bool is_drawn = std::ranges::any_of(
        plan.passes, [&](const PreparedPass& prepared) { return prepared.declaration == &pass; });
    if (!is_drawn) names.push_back("pass " + pass.id);
  }
}

/// Of the first level of all layers; 0 when the parameters give it no size.
double bytes_of(const ResourceDeclaration& resource, const ExpressionVariables& variables) {
  const double layers = resource.kind == TextureKind::cube ? 6.0
                        : resource.layers.is_empty()       ? 1.0
                                                           : resource.layers.evaluate(variables);
  const double texels = resource.width.evaluate(variables) * resource.height.evaluate(variables) * layers;
  const TextureFormat& format = find_texture_format(resource.format(variables), resource.where);
  const double bytes = texels * format.bytes_per_texel;
  return std::isfinite(bytes) ? std::max(bytes, 0.0) : 0.0;
}

}  // namespace

std::vector<std::string> left_out(const RunInputs& inputs, const Plan& plan) {
  std::vector<std::string> names;
  add_passes(inputs.technique.passes, plan, names);
  const ExpressionVariables variables = run_variables(inputs);
  for (const ResourceDeclaration& resource : inputs.technique.resources) {
    if (plan.targets->find(resource.name) != nullptr) continue;
    names.push_back(
        fmt::format("texture {} ({:.2f} MiB)", resource.name, bytes_of(resource, variables) / kMiB));
  }
  for (const BufferDeclaration& buffer : inputs.technique.buffers) {
    if (plan.targets->buffers().find(buffer.name) != nullptr) continue;
    const double count = std::max(buffer.count.evaluate(variables), 0.0);
    names.push_back(fmt::format("buffer {} ({:.2f} MiB)", buffer.name,
                                count * static_cast<double>(buffer.element->bytes()) / kMiB));
  }
  if (plan.culled_triangles > 0) {
    names.push_back(fmt::format(
        "{:.3g} % of {} triangles drawn into maps (outside them)",
        100.0 * static_cast<double>(plan.culled_triangles) / static_cast<double>(plan.scene_pass_triangles),
        plan.scene_pass_triangles));
  }
  return names;
}

}  // namespace umbrameter
