// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a verb shares with others through the store in --out: truths (lab/stored_reference.h) and answers of its own
// (lab/answers.h).

#include "cli/lazy_renderer.h"
#include "cli/staging.h"
#include "cli/verbs.h"
#include "lab/answers.h"
#include "lab/stored_frames.h"
#include "lab/stored_reference.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

class VerbCache {
 public:
  /// With an empty `folder` nothing is remembered. Error{input} for one that cannot be written. `options` must outlive it.
  VerbCache(const GlobalOptions& options, const std::filesystem::path& folder, bool reuse);

  /// A ray tracer of the picture's samples and target; lives as long as this.
  Renderer& reference(const PictureQuality& picture);

  /// The renderer of runs with their pictures in the store; itself without one. Lives as long as this.
  Renderer& frames(Renderer& realtime, FrameUse use = {});

  /// The answers in the store; without one nothing is kept.
  Answers& answers() { return answers_; }
  /// The store; null without a folder.
  LazyStore* store() { return store_ ? &*store_ : nullptr; }
  /// For files in the making; there only with a store.
  const std::filesystem::path& scratch() const { return scratch_->folder(); }
  /// Who makes what is kept; `realtime` is one of open_realtime_renderer().
  Makers makers(const Renderer& realtime) const;

  /// By all of them, since it was last asked.
  ReusedTruths take_reused();
  size_t take_reused_frames() { return frames_ ? frames_->take_reused() : 0; }
  /// What was found damaged.
  std::vector<std::string> take_warnings();

 private:
  struct Reference {
    LazyRenderer tracer;
    std::optional<StoredReference> stored;
  };

  const GlobalOptions& options_;
  bool reuse_;
  std::optional<Staging> scratch_;
  std::optional<LazyStore> store_;
  Answers answers_;
  std::optional<StoredFrames> frames_;
  std::vector<std::unique_ptr<Reference>> references_;
};

/// "3 truths reused, about 1.2 s saved".
std::string reused_line(const ReusedTruths& reused);

/// HashOfTechnique of techniques and engines.
std::string hash_of_technique(const std::string& id_or_path);

/// "2 stored pictures of runs reused"; absent for none.
std::optional<std::string> reused_frames_line(size_t count);

/// Error{input} for --no-reuse without --out.
void require_store(bool no_reuse, const GlobalOptions& options);

/// Prints what was found damaged and how much was reused, where there is something to say.
void print_reuse(VerbCache& cache);

}  // namespace umbrameter
