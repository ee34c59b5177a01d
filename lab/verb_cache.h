// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a verb shares with others through a store: truths (lab/stored_reference.h), pictures of runs (lab/stored_frames.h) and
// answers of its own (lab/answers.h).

#include "lab/answers.h"
#include "lab/lazy_renderer.h"
#include "lab/stored_frames.h"
#include "lab/stored_reference.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// What the composition root knows of those who make what is kept.
struct CacheTools {
  std::function<std::unique_ptr<Renderer>(const PictureQuality&)> open_reference;
  std::string reference_maker;  // Makers::reference
  std::function<Makers(const Renderer& realtime)> makers;
  HashOfTechnique hash_of_technique;
};

/// Where a cache lies. Without a folder nothing is remembered.
struct CachePlace {
  std::filesystem::path folder;
  std::shared_ptr<const std::filesystem::path>
      scratch;        // an existing folder for files in the making; null without a folder
  bool reuse = true;  // else nothing is found, and everything is kept
};

class VerbCache {
 public:
  VerbCache(CacheTools tools, CachePlace place);
  VerbCache(const VerbCache&) = delete;  // parts of it know each other

  /// A ray tracer of the picture's samples and target; lives as long as this.
  Renderer& reference(const PictureQuality& picture);

  /// The renderer of runs with their pictures in the store; itself without one. Lives as long as this.
  Renderer& frames(Renderer& realtime, FrameUse use = {});

  /// The answers in the store; without one nothing is kept.
  Answers& answers() { return answers_; }
  /// The store; null without a folder.
  LazyStore* store() { return store_ ? &*store_ : nullptr; }
  /// For files in the making; there only with a store.
  const std::filesystem::path& scratch() const { return *place_.scratch; }
  /// Who makes what is kept.
  Makers makers(const Renderer& realtime) const { return tools_.makers(realtime); }

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

  CacheTools tools_;
  CachePlace place_;
  std::optional<LazyStore> store_;
  Answers answers_;
  std::optional<StoredFrames> frames_;
  std::vector<std::unique_ptr<Reference>> references_;
};

}  // namespace umbrameter
