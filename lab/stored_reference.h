// SPDX-License-Identifier: Apache-2.0
#pragma once
// A ray tracer that looks into a store before it works, so that no truth is rendered twice (docs/store.md).

#include "core/renderer.h"
#include "lab/keys.h"
#include "results/json/record.h"
#include "results/picture_quality.h"
#include "store/lazy_store.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

namespace umbrameter {

struct ReusedTruths {
  size_t count = 0;
  double saved_s = 0.0;  // that they took when they were rendered

  ReusedTruths& operator+=(const ReusedTruths& other) {
    count += other.count;
    saved_s += other.saved_s;
    return *this;
  }
};

class StoredReference final : public Renderer {
 public:
  /// `tracer` has the samples and target of `picture`; size and seed are those of each request. Without `reuse` nothing is
  /// found, and everything is kept. `scratch`: an existing folder for files in the making. All but `picture` must outlive
  /// it.
  StoredReference(Renderer& tracer, const PictureQuality& picture, LazyStore& store, Makers makers,
                  bool reuse, std::filesystem::path scratch)
      : tracer_(tracer),
        picture_(picture),
        store_(store),
        makers_(std::move(makers)),
        reuse_(reuse),
        scratch_(std::move(scratch)) {}

  /// The truth of the scene from its camera, under the key that a sweep gives it: from the store, with `wall_time_s` of when
  /// it was rendered, or else rendered and kept. Throws what the tracer and the store do.
  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override;

  /// Since it was last asked.
  ReusedTruths take_reused();

 private:
  Frame make(const Scene& scene, const RenderRequest& request, const std::string& key, RecordHead head,
             Progress& progress);

  Renderer& tracer_;
  PictureQuality picture_;
  LazyStore& store_;
  Makers makers_;
  bool reuse_;
  std::filesystem::path scratch_;
  ReusedTruths reused_;
};

}  // namespace umbrameter
