// SPDX-License-Identifier: Apache-2.0
#include "cli/verb_cache.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/reference_renderer.h"
#include "cli/run_renderer.h"
#include "core/error.h"

#include <fmt/format.h>

namespace umbrameter {

std::string hash_of_technique(const std::string& id_or_path) {
  return find_run(id_or_path, find_home()).hash;
}

VerbCache::VerbCache(const GlobalOptions& options, const std::filesystem::path& folder, bool reuse)
    : options_(options), reuse_(reuse) {
  if (folder.empty()) return;
  scratch_.emplace(folder);
  store_.emplace(folder);
  answers_ = Answers(*store_, reuse);
}

Makers VerbCache::makers(const Renderer& realtime) const {
  return {kReferenceMaker, run_identity(realtime), hash_folder(find_home().shaders)};
}

Renderer& VerbCache::reference(const PictureQuality& picture) {
  const auto open = [this, picture] { return open_reference_renderer(options_, picture); };
  references_.push_back(std::make_unique<Reference>(Reference{LazyRenderer(open), {}}));
  Reference& reference = *references_.back();
  if (!store_) return reference.tracer;
  Makers makers;
  makers.reference = kReferenceMaker;
  reference.stored.emplace(reference.tracer, picture, *store_, makers, reuse_, scratch_->folder());
  return *reference.stored;
}

Renderer& VerbCache::frames(Renderer& realtime, FrameUse use) {
  if (!store_) return realtime;
  use.find = use.find && reuse_;
  if (!frames_)
    frames_.emplace(realtime, *store_, makers(realtime), hash_of_technique, use, scratch_->folder());
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

std::string reused_line(const ReusedTruths& reused) {
  return fmt::format("{} truth{} reused, about {:.2g} s saved", reused.count, reused.count == 1 ? "" : "s",
                     reused.saved_s);
}

std::optional<std::string> reused_frames_line(size_t count) {
  if (count == 0) return std::nullopt;
  return fmt::format("{} stored picture{} of runs reused", count, count == 1 ? "" : "s");
}

void require_store(bool no_reuse, const GlobalOptions& options) {
  if (no_reuse && options.out.empty())
    fail_input("--no-reuse needs --out", {}, "without a store nothing is reused");
}

void print_reuse(VerbCache& cache) {
  print_warnings(cache.take_warnings());
  const ReusedTruths truths = cache.take_reused();
  if (truths.count > 0) print_note(reused_line(truths));
  if (const auto line = reused_frames_line(cache.take_reused_frames())) print_note(*line);
  const size_t answers = cache.answers().take_reused();
  if (answers > 0) print_note(fmt::format("{} stored answer{} reused", answers, answers == 1 ? "" : "s"));
}

}  // namespace umbrameter
