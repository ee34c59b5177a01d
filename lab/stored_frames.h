// SPDX-License-Identifier: Apache-2.0
#pragma once
// A renderer of runs that looks into a store before it draws, so that no verb draws a picture that another has (docs/store.md).
// Not here: scores of pictures (lab/validation_cache.h, lab/answers.h).

#include "core/renderer.h"
#include "lab/keys.h"
#include "store/lazy_store.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace umbrameter {

struct FrameUse {
  bool find = true;
  bool keep_runs = true;  // not of searches: their pictures are many, and nobody asks for them again
  bool keep_surfaces = true;
};

/// Keeps a frame under a frame_key(), whose planes stand in these objects of the store.
void keep_frame(Store& store, const std::string& key, const Frame& frame,
                std::span<const std::string> objects);

/// Hash of the files of a technique or engine, by its id or folder (RenderRequest::technique).
using HashOfTechnique = std::function<std::string(const std::string& id_or_path)>;

class StoredFrames final : public Renderer {
 public:
  /// `scratch`: an existing folder for files in the making. Renderer, store and `scratch` must outlive it.
  StoredFrames(Renderer& renderer, LazyStore& store, Makers makers, HashOfTechnique hash_of, FrameUse use,
               const std::filesystem::path& scratch)
      : renderer_(renderer),
        store_(store),
        makers_(std::move(makers)),
        hash_of_(std::move(hash_of)),
        use_(use),
        scratch_(scratch) {}

  /// Found with `wall_time_s` of when it was drawn, or else drawn and kept. Pictures that take blockers from a truth are
  /// drawn and not kept. Throws what the renderer and the store do.
  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override;
  /// Draws, as frames cannot be timed otherwise; the first one is kept.
  PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) override;

  /// Pictures found, since it was last asked.
  size_t take_reused() { return std::exchange(reused_, 0); }

 private:
  /// Empty: not kept.
  std::string key_of(const Scene& scene, const RenderRequest& request);
  std::optional<Frame> find(const std::string& key);
  bool keeps(const RenderRequest& request) const {
    return request.technique.empty() ? use_.keep_surfaces : use_.keep_runs;
  }
  /// Read into `made`, or the last surfaces.
  const Image& part(const std::string& object, Image& made);
  void add_part(const std::string& object, Image& image);
  void keep(const std::string& key, const RenderRequest& request, const Frame& frame);

  Renderer& renderer_;
  LazyStore& store_;
  Makers makers_;
  HashOfTechnique hash_of_;
  FrameUse use_;
  const std::filesystem::path& scratch_;
  size_t reused_ = 0;
  std::map<std::string, std::string> hashes_;  // of techniques
  std::map<std::string, std::string> kept_;    // object by the hash of its planes
  std::string last_object_;                    // of surfaces, which runs of a view share
  Image last_surfaces_;
};

}  // namespace umbrameter
