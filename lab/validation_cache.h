// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a validation finds in a store and leaves there, so that the same question is not rendered twice (docs/store.md).

#include "lab/keys.h"
#include "lab/scene_run.h"
#include "store/lazy_store.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace umbrameter {

class ValidationCache {
 public:
  /// Without `reuse` nothing is found, and everything is kept.
  ValidationCache(LazyStore& store, Makers makers, bool reuse)
      : store_(store), makers_(std::move(makers)), reuse_(reuse) {}

  /// Sets what is known of the scene and its runs, and puts their images into `folder`.
  void find_results(const SceneSource& source, const ValidationPlan& plan,
                    const std::filesystem::path& folder, SceneResult& scene,
                    std::vector<TechniqueFrame>& runs);
  // What follows keeps what was not known, whose images lie in `folder`; they become links to what is kept. A second
  // time, and without the thing, it does nothing. So all of it may be called as soon as the thing is there: killed at any
  // moment, a validation goes on from there.
  void keep_truth(const SceneSource& source, const ValidationPlan& plan, const std::filesystem::path& folder,
                  const SceneResult& scene);
  void keep_parity(const SceneSource& source, const ValidationPlan& plan, const std::filesystem::path& folder,
                   const SceneResult& scene);
  /// Runs that were not compared and failures that may pass are not kept.
  /// The picture without shadows that parity is of, which other verbs look at, too.
  void keep_surfaces(const SceneSource& source, const ValidationPlan& plan,
                     const std::filesystem::path& folder, const Frame& surfaces);
  void keep_run(const SceneSource& source, const ValidationPlan& plan, const std::filesystem::path& folder,
                const SceneResult& scene, const TechniqueFrame& run);

  /// Whether the verdict on `run` was known; then it is set.
  bool find_verdict(const TechniqueFrame& baseline, TechniqueFrame& run);
  void keep_verdict(const TechniqueFrame& baseline, const TechniqueFrame& run);

  /// Sets the causes of `run`, one of the scene's `runs`, where they are known, or that they were too dear where the plan asks
  /// for no more than that.
  void find_causes(const ValidationPlan& plan, TechniqueFrame& run, std::span<const TechniqueFrame> runs);
  /// Does nothing for a run without causes.
  void keep_causes(const TechniqueFrame& run, std::span<const TechniqueFrame> runs);

  /// Whether the light is known to reach nothing in the picture.
  bool is_unlit(const SceneSource& source, const ValidationPlan& plan);
  void keep_unlit(const SceneSource& source, const ValidationPlan& plan);

 private:
  std::optional<std::string> find(const std::string& key);
  std::string reference_of(const SceneSource& source, const ValidationPlan& plan) const;

  LazyStore& store_;
  Makers makers_;
  bool reuse_;
  std::set<std::string> kept_;  // keys of the scene recalled last that need not be put again
};

}  // namespace umbrameter
