// SPDX-License-Identifier: Apache-2.0
#include "lab/stored_truth.h"

#include "core/clock.h"
#include "core/image_io.h"
#include "metrics/error/lit_error.h"
#include "metrics/image/parity.h"
#include "results/json/json_parts.h"
#include "results/metadata.h"

#include <algorithm>
#include <utility>

namespace umbrameter {
namespace {

/// Standard errors, sample counts and shares of proven pixels, over the covered pixels.
void summarise_errors(const Image& image, ReferenceResult& result) {
  const auto visibility = image.plane("visibility");
  const auto irradiance = image.plane("unshadowed_irradiance");
  const auto se = image.plane("visibility_se");
  const auto samples = image.plane("sample_count");
  const auto primitive = image.plane("primitive_id");
  double covered = 0.0;
  for (size_t i = 0; i < se.size(); ++i) {
    if (primitive[i] < 0.0f) continue;
    covered += 1.0;
    result.mean_visibility_se += static_cast<double>(se[i]);
    result.mean_sample_count += static_cast<double>(samples[i]);
    result.max_visibility_se = std::max(result.max_visibility_se, static_cast<double>(se[i]));
    // None where visibility is proven (reference/reference.h), and none where the light cannot be anyway.
    if (samples[i] > 0.0f || irradiance[i] <= 0.0f) continue;
    (visibility[i] > 0.0f ? result.proven_lit_share : result.proven_dark_share) += 1.0;
  }
  if (covered == 0.0) return;
  result.mean_visibility_se /= covered;
  result.mean_sample_count /= covered;
  result.proven_lit_share /= covered;
  result.proven_dark_share /= covered;
}

void add_model_gap(const Image& image, ReferenceResult& result) {
  const std::vector<uint8_t> scorable = scorable_mask(image);
  result.scorable_pixels = static_cast<size_t>(std::ranges::count(scorable, 1));
  if (!image.has("irradiance_half_a")) return;  // a truth of an earlier version
  const auto gap = measure_model_gap(image, scorable);
  if (!gap) return;
  result.model_gap_rmse = gap->rmse;
  result.model_gap_lit_rmse = gap->lit_rmse;
}

}  // namespace

ReferenceResult describe_truth(const Frame& frame) {
  ReferenceResult result;
  summarise_errors(frame.image, result);
  add_model_gap(frame.image, result);
  result.device = frame.device;
  result.wall_time_s = frame.wall_time_s;
  result.warnings = frame.warnings;
  return result;
}

RenderedTruth render_truth(Renderer& reference, const Scene& scene, const RenderRequest& request,
                           Progress& progress) {
  const Clock::time_point start = Clock::now();
  RenderedTruth truth{reference.render(scene, request, progress), {}, 0.0};
  truth.duration_s = seconds_since(start);
  truth.result = describe_truth(truth.frame);
  add_metadata(truth.frame, scene, request);
  return truth;
}

std::optional<Frame> find_truth(Store& store, const std::string& key) {
  const auto json = store.find(key);
  const auto record = json ? parse_reference_record(*json) : std::nullopt;
  if (!record) return std::nullopt;
  Frame frame;
  frame.image = read_image(store.path_of(record->result.image_file));
  frame.device = record->result.device;
  frame.wall_time_s = record->result.wall_time_s;
  frame.warnings = record->result.warnings;
  return frame;
}

void keep_truth(Store& store, const std::string& key, RecordHead head, const RenderedTruth& truth,
                const std::filesystem::path& scratch) {
  ReferenceRecord record{std::move(head), truth.result};
  record.head.duration_s = truth.duration_s;
  record.result.image_file = keep_image(store, truth.frame.image, scratch);
  store.put({key, EntryKind::reference, to_json_text(record)});
}

void keep_parity(Store& store, const std::string& key, const ParityNumbers& parity) {
  store.put({key, EntryKind::parity, parity_json(parity).dump()});
}

std::string keep_image(Store& store, const Image& image, const std::filesystem::path& scratch) {
  const std::filesystem::path file = scratch / "image.exr";
  write_exr(file, image);
  const std::string object = store.keep(file);
  std::filesystem::remove(file);
  return object;
}

}  // namespace umbrameter
