// SPDX-License-Identifier: Apache-2.0
#include "cli/truth_memory.h"

#include "cli/reference_renderer.h"

#include <fmt/format.h>

namespace umbrameter {

TruthMemory::TruthMemory(const GlobalOptions& options, const std::filesystem::path& folder, bool reuse)
    : options_(options), reuse_(reuse) {
  if (folder.empty()) return;
  scratch_.emplace(folder);
  store_.emplace(folder);
}

Renderer& TruthMemory::reference(const PictureQuality& picture) {
  const auto open = [this, picture] { return open_reference_renderer(options_, picture); };
  references_.push_back(std::make_unique<Reference>(Reference{LateRenderer(open), {}}));
  Reference& reference = *references_.back();
  if (!store_) return reference.tracer;
  Makers makers;
  makers.reference = kReferenceMaker;
  reference.stored.emplace(reference.tracer, picture, *store_, makers, reuse_, scratch_->folder());
  return *reference.stored;
}

ReusedTruths TruthMemory::take_reused() {
  ReusedTruths all;
  for (const auto& reference : references_) {
    if (reference->stored) all += reference->stored->take_reused();
  }
  return all;
}

std::vector<std::string> TruthMemory::take_warnings() {
  return store_ ? store_->take_warnings() : std::vector<std::string>();
}

std::string reused_line(const ReusedTruths& reused) {
  return fmt::format("{} truth{} reused, about {:.2g} s saved", reused.count, reused.count == 1 ? "" : "s",
                     reused.saved_s);
}

}  // namespace umbrameter
