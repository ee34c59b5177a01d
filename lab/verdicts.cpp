// SPDX-License-Identifier: Apache-2.0
#include "lab/verdicts.h"

#include "core/image_io.h"
#include "lab/stored_runs.h"
#include "lab/stored_truth.h"

#include <algorithm>

namespace umbrameter {
namespace {

/// The last one asked for: runs of a scene come together.
template <class Value>
class Last {
 public:
  template <class Find>
  const std::optional<Value>& get(const std::string& key, Find find) {
    if (key_ != key) value_ = find(key);
    key_ = key;
    return value_;
  }

 private:
  std::string key_;
  std::optional<Value> value_;
};

/// The run labelled `label` that looks at the same truth with the same seed.
const RunRecord* labelled(std::span<const RunRecord> runs, const std::string& label, const RunRecord& run) {
  const auto found = std::ranges::find_if(runs, [&](const RunRecord& other) {
    return other.result.label == label && other.reference == run.reference &&
           other.head.picture.seed == run.head.picture.seed;
  });
  return found == runs.end() ? nullptr : &*found;
}

std::string label_of(Store& store, const std::string& key) {
  const auto run = find_record(store, key);
  return run ? run->result.label : "";
}

}  // namespace

Image picture_to_store(const Image& image, std::span<const uint8_t> mask) {
  Image picture(image.width, image.height);
  picture.metadata = image.metadata;
  std::ranges::copy(image.plane("visibility"), picture.add_plane("visibility").begin());
  std::ranges::copy(mask, picture.add_plane("scored").begin());
  return picture;
}

std::vector<uint8_t> stored_mask(const Image& picture) {
  std::vector<uint8_t> mask;
  if (!picture.has("scored")) return mask;
  for (const float scored : picture.plane("scored")) mask.push_back(scored > 0.0f ? 1 : 0);
  return mask;
}

std::optional<StoredPicture> find_picture(Store& store, const std::string& key) {
  const auto run = find_record(store, key);
  if (!run || run->result.failure || run->result.image_file.empty()) return std::nullopt;
  StoredPicture picture{read_image(store.path_of(run->result.image_file)), {}};
  picture.mask = stored_mask(picture.image);
  if (picture.mask.empty()) return std::nullopt;
  return picture;
}

void judge_runs(Store& store, std::span<RunRecord> runs, const std::string& baseline) {
  Last<Frame> truths;
  Last<StoredPicture> baselines;
  const auto picture_of = [&](const std::string& key) { return find_picture(store, key); };
  for (RunRecord& run : runs) {
    const RunRecord* chosen = baseline.empty() ? nullptr : labelled(runs, baseline, run);
    const std::string& other = baseline.empty() ? run.baseline : chosen != nullptr ? chosen->key : run.key;
    if (other.empty() || other == run.key) continue;
    const auto picture = picture_of(run.key);
    if (!picture) continue;
    const auto& first = baselines.get(other, picture_of);
    const auto& truth =
        truths.get(run.reference, [&](const std::string& key) { return find_truth(store, key); });
    if (!first || !truth) continue;
    run.result.judgement.verdict = judge_runs({picture->image, picture->mask}, {first->image, first->mask},
                                              label_of(store, other), truth->image);
  }
}

}  // namespace umbrameter
