// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/history.h"

#include "realtime/executor/kept_textures.h"
#include "realtime/manifest/names.h"

#include <array>

namespace umbrameter {
namespace {

std::string previous_of(const std::string& name) {
  return std::string(kPrevious) + name;
}

bool is_alike(const Texture& one, const Texture& two) {
  return &one.format() == &two.format() && one.width() == two.width() && one.height() == two.height() &&
         one.levels() == two.levels() && one.layers() == two.layers();
}

void take(Plan& next, const ResourceDeclaration& resource, const std::string& name,
          const std::shared_ptr<const Texture>& texture) {
  const auto own = next.targets->share(name);
  if (own == nullptr || texture == nullptr) return;
  if (!is_alike(*own, *texture))
    fail_input(fmt::format("resource '{}' is {}x{} in one frame and {}x{} in the next", resource.name,
                           texture->width(), texture->height(), own->width(), own->height()),
               resource.where, "a technique with history keeps the sizes of its textures");
  next.targets->replace(name, texture);
}

void take_buffer(Plan& next, const BufferDeclaration& declared, const std::string& name,
                 const BufferTarget* from) {
  const BufferTarget* own = next.targets->buffers().find(name);
  if (own == nullptr || from == nullptr || from->buffer == nullptr) return;
  if (own->count != from->count)
    fail_input(fmt::format("buffer '{}' has {} elements in one frame and {} in the next", declared.name,
                           from->count, own->count),
               declared.where, "a technique with history keeps the sizes of its buffers");
  next.targets->buffers().replace(name, from->buffer);
}

void hand_over_buffers(const Technique& technique, const BufferTargets& earlier, Plan& next) {
  for (const BufferDeclaration& declared : technique.buffers) {
    const BufferTarget* current = earlier.find(declared.name);
    const BufferTarget* before = earlier.find(previous_of(declared.name));
    take_buffer(next, declared, declared.name, before == nullptr ? current : before);
    if (before != nullptr) take_buffer(next, declared, previous_of(declared.name), current);
  }
}

}  // namespace

void hand_over(const Technique& technique, const Plan& earlier, Plan& next) {
  for (const ResourceDeclaration& resource : technique.resources) {
    const auto current = earlier.targets->share(resource.name);
    const auto before = earlier.targets->share(previous_of(resource.name));
    take(next, resource, resource.name, before == nullptr ? current : before);
    if (before != nullptr) take(next, resource, previous_of(resource.name), current);
  }
  hand_over_buffers(technique, earlier.targets->buffers(), next);
}

void keep_unchanged(const RunContents& earlier, const RunContents& contents, Plan& next) {
  std::map<std::string, std::shared_ptr<const Texture>> known;
  for (const auto& [name, content] : contents.last) {
    const auto before = earlier.last.find(name);
    const bool is_same = !content.empty() && before != earlier.last.end() && before->second == content;
    const bool alternates = next.targets->share(previous_of(name)) != nullptr;
    if (auto texture = next.targets->share(name); is_same && !alternates && texture != nullptr)
      known[name] = std::move(texture);
  }
  const std::vector<bool> is_needed = needed_steps(contents, known);
  for (size_t i = 0; i < is_needed.size(); ++i) next.steps[contents.steps[i].step].is_kept = !is_needed[i];
}

void clear_previous(const Technique& technique, const Plan& first) {
  for (const ResourceDeclaration& resource : technique.resources) {
    const auto texture = first.targets->share(previous_of(resource.name));
    if (texture != nullptr && texture->id() != 0) clear_texture(*texture, std::array{0.0});
  }
  for (const BufferDeclaration& declared : technique.buffers) {
    const BufferTarget* target = first.targets->buffers().find(previous_of(declared.name));
    if (target != nullptr && target->buffer != nullptr) clear_buffer(*target, std::array{0.0});
  }
}

}  // namespace umbrameter
