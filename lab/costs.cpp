// SPDX-License-Identifier: Apache-2.0
#include "lab/costs.h"

#include "core/hash.h"
#include "core/statistics.h"
#include "results/json/record.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

constexpr int kNewest = 400;  // entries a kind: medians of far fewer are steady

double pixels_of(int width_px, int height_px) {
  return static_cast<double>(width_px) * static_cast<double>(height_px);
}

/// The newest entries of a kind, altered ones left out: a large store need not be read whole for a median.
std::vector<std::string> newest(const Store& store, EntryKind kind) {
  Database database(store.folder() / kStoreFile, Database::Mode::read);
  Statement query = database.prepare(
      fmt::format("SELECT json, hash FROM entries WHERE kind = ? ORDER BY rowid DESC LIMIT {}", kNewest));
  query.bind({to_text(kind)});
  std::vector<std::string> texts;
  while (query.step()) {
    std::string json = query.text(0);
    if (hash_text(json) == query.text(1)) texts.push_back(std::move(json));
  }
  return texts;
}

}  // namespace

Costs costs_of(Store* store) {
  Costs costs;
  if (store == nullptr) return costs;
  for (const std::string& json : newest(*store, EntryKind::run)) {
    const auto run = parse_run_record(json);
    if (!run || run->result.failure) continue;
    const double pixels = pixels_of(run->head.picture.width_px, run->head.picture.height_px);
    costs.run_s_per_pixel[run->result.technique].push_back(run->head.duration_s / pixels);
    if (const auto frame = total_time(run->result.pass_times))
      costs.frame_s_per_pixel[run->result.technique].push_back(1e-3 * frame->median_ms / pixels);
  }
  for (const std::string& json : newest(*store, EntryKind::reference)) {
    const auto truth = parse_reference_record(json);
    if (!truth) continue;
    const double samples = pixels_of(truth->head.picture.width_px, truth->head.picture.height_px) *
                           truth->head.picture.samples_per_pixel;
    costs.reference_s_per_sample.push_back(truth->head.duration_s / samples);
  }
  return costs;
}

Estimate estimate_run(const Costs& costs, const std::string& technique, const PictureQuality& quality,
                      const std::optional<TimingPlan>& timing) {
  const double pixels = pixels_of(quality.width_px, quality.height_px);
  double timing_s = 0.0;
  if (timing) {
    const auto frames = costs.frame_s_per_pixel.find(technique);
    const double frame_s =
        pixels * (frames == costs.frame_s_per_pixel.end() ? kRoughFrame_s_per_pixel : median(frames->second));
    timing_s = 2.0 * std::min(timing->budget_s, timing->wanted_frames * frame_s);
  }
  const auto found = costs.run_s_per_pixel.find(technique);
  if (found == costs.run_s_per_pixel.end())
    return {kRoughRun_s + kRoughRun_s_per_pixel * pixels + timing_s, 0};
  return {median(found->second) * pixels + timing_s, found->second.size()};
}

Estimate estimate_reference(const Costs& costs, const PictureQuality& quality) {
  const double samples = pixels_of(quality.width_px, quality.height_px) * quality.samples_per_pixel;
  if (costs.reference_s_per_sample.empty()) return {kRoughReference_s_per_sample * samples, 0};
  return {median(costs.reference_s_per_sample) * samples, costs.reference_s_per_sample.size()};
}

}  // namespace umbrameter
