// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ray tracers that share what the store in --out knows (lab/stored_reference.h).

#include "cli/late_renderer.h"
#include "cli/staging.h"
#include "cli/verbs.h"
#include "lab/stored_reference.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

class TruthMemory {
 public:
  /// With an empty `folder` nothing is remembered. Error{input} for one that cannot be written. `options` must outlive it.
  TruthMemory(const GlobalOptions& options, const std::filesystem::path& folder, bool reuse);

  /// A ray tracer of the picture's samples and target; lives as long as this.
  Renderer& reference(const PictureQuality& picture);

  /// By all of them, since it was last asked.
  ReusedTruths take_reused();
  /// What was found damaged.
  std::vector<std::string> take_warnings();

 private:
  struct Reference {
    LateRenderer tracer;
    std::optional<StoredReference> stored;
  };

  const GlobalOptions& options_;
  bool reuse_;
  std::optional<Staging> scratch_;
  std::optional<LateStore> store_;
  std::vector<std::unique_ptr<Reference>> references_;
};

/// "3 truths reused, about 1.2 s saved".
std::string reused_line(const ReusedTruths& reused);

}  // namespace umbrameter
