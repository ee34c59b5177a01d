// SPDX-License-Identifier: Apache-2.0
#include "lab/verb_cache.h"

#include <utility>

namespace umbrameter {

VerbCache::VerbCache(CacheTools tools, CachePlace place)
    : tools_(std::move(tools)), place_(std::move(place)) {
  if (place_.folder.empty()) return;
  store_.emplace(place_.folder);
  answers_ = Answers(*store_, place_.reuse);
}

Renderer& VerbCache::reference(const PictureQuality& picture) {
  const auto open = [this, picture] { return tools_.open_reference(picture); };
  references_.push_back(std::make_unique<Reference>(Reference{LazyRenderer(open), {}}));
  Reference& reference = *references_.back();
  if (!store_) return reference.tracer;
  Makers makers;
  makers.reference = tools_.reference_maker;
  reference.stored.emplace(reference.tracer, picture, *store_, makers, place_.reuse, scratch());
  return *reference.stored;
}

Renderer& VerbCache::frames(Renderer& realtime, FrameUse use) {
  if (!store_) return realtime;
  use.find = use.find && place_.reuse;
  if (!frames_)
    frames_.emplace(realtime, *store_, makers(realtime), tools_.hash_of_technique, use, scratch());
  return *frames_;
}

ReusedTruths VerbCache::take_reused() {
  ReusedTruths all;
  for (const auto& reference : references_) {
    if (reference->stored) all += reference->stored->take_reused();
  }
  return all;
}

std::vector<std::string> VerbCache::take_warnings() {
  return store_ ? store_->take_warnings() : std::vector<std::string>();
}

}  // namespace umbrameter
