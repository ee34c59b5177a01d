// SPDX-License-Identifier: Apache-2.0
#include "lab/stored_reference.h"

#include "lab/stored_truth.h"
#include "scenes/scene_hash.h"

namespace umbrameter {

Frame StoredReference::render(const Scene& scene, const RenderRequest& request, Progress& progress) {
  PictureQuality picture = picture_;
  picture.width_px = request.width_px;
  picture.height_px = request.height_px;
  picture.seed = request.seed;
  RecordHead head = make_head(scene.name, scene, picture);
  head.scene_hash = hash_scene(scene);  // a tuner moves the camera, and leaves the hash of the file
  const std::string key = reference_key(head.scene_hash, scene.active_light, picture, makers_);
  auto known = reuse_ && store_.exists() ? find_truth(store_.store(), key) : std::nullopt;
  if (!known) return make(scene, request, key, std::move(head), progress);
  ++reused_.count;
  reused_.saved_s += known->wall_time_s;
  return std::move(*known);
}

Frame StoredReference::make(const Scene& scene, const RenderRequest& request, const std::string& key,
                            RecordHead head, Progress& progress) {
  RenderedTruth truth = render_truth(tracer_, scene, request, progress);
  truth.frame.image.metadata["scene_hash"] = head.scene_hash;
  keep_truth(store_.store(), key, std::move(head), truth, scratch_);
  return std::move(truth.frame);
}

ReusedTruths StoredReference::take_reused() {
  return std::exchange(reused_, {});
}

}  // namespace umbrameter
