// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/kept_textures.h"

#include "realtime/manifest/names.h"

#include <algorithm>
#include <optional>
#include <set>

namespace umbrameter {
namespace {

using Known = std::map<std::string, std::shared_ptr<const Texture>>;

/// The first known texture that the step cannot do with: none of the others is wrong for it.
std::optional<std::string> conflict(const StepUse& use, const RunContents& contents, const Known& known) {
  for (const TextureUse& written : use.writes) {
    if (known.contains(written.name)) return written.name;
  }
  for (const TextureUse& read : use.reads) {
    if (known.contains(read.name) && contents.last.at(read.name) != read.content) return read.name;
  }
  return std::nullopt;
}

}  // namespace

std::vector<bool> needed_steps(const RunContents& contents, Known& known) {
  for (;;) {
    std::vector<bool> is_needed(contents.steps.size(), false);
    std::set<std::string> wanted{std::string(kVisibility)};
    std::optional<std::string> wrong;
    for (size_t i = contents.steps.size(); i-- > 0 && !wrong;) {
      const StepUse& use = contents.steps[i];
      is_needed[i] = std::ranges::any_of(
          use.writes, [&](const TextureUse& written) { return wanted.contains(written.name); });
      if (!is_needed[i]) continue;
      wrong = conflict(use, contents, known);
      for (const auto* textures : {&use.reads, &use.writes}) {
        for (const TextureUse& texture : *textures) {
          if (!known.contains(texture.name)) wanted.insert(texture.name);
        }
      }
    }
    if (!wrong) return is_needed;
    known.erase(*wrong);
  }
}

void KeptTextures::give(const RunContents& contents, Plan& plan) {
  Known known;
  for (const auto& [name, content] : contents.last) {
    if (content.empty() || plan.targets->share(name) == nullptr) continue;
    if (auto texture = kept_.find(content)) known[name] = std::move(texture);
  }
  const std::vector<bool> is_needed = needed_steps(contents, known);
  for (size_t i = 0; i < is_needed.size(); ++i) {
    plan.steps[contents.steps[i].step].is_kept = !is_needed[i];
    ++(is_needed[i] ? counts_.drawn : counts_.kept);
  }
  for (const auto& [name, texture] : known) plan.targets->replace(name, texture);
  kept_.make_room(plan.targets->declared_bytes());
}

void KeptTextures::take(const RunContents& contents, const Plan& plan) {
  std::set<std::string> undrawn;
  for (const StepUse& use : contents.steps) {
    if (!plan.steps[use.step].is_kept) continue;
    for (const TextureUse& written : use.writes) undrawn.insert(written.name);
  }
  for (const auto& [name, content] : contents.last) {
    const std::shared_ptr<const Texture> texture = plan.targets->share(name);
    if (content.empty() || texture == nullptr || texture->id() == 0 || undrawn.contains(name)) continue;
    if (texture->bytes() > budget_bytes_ || kept_.find(content) != nullptr) continue;
    kept_.make_room(texture->bytes());
    kept_.keep(content, texture, texture->bytes());
  }
}

}  // namespace umbrameter
