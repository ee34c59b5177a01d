#include "study/sweep/costs.h"

#include "core/statistics.h"
#include "study/sweep/record.h"

namespace umbrameter {
namespace {

double pixels_of(int width_px, int height_px) {
  return static_cast<double>(width_px) * static_cast<double>(height_px);
}

}  // namespace

Costs costs_of(Store* store) {
  Costs costs;
  if (store == nullptr) return costs;
  for (const Entry& entry : store->entries(EntryKind::run)) {
    const auto run = parse_run_record(entry.json);
    if (!run || run->result.failure) continue;
    costs.run_s_per_pixel[run->result.technique].push_back(
        run->head.duration_s / pixels_of(run->head.width_px, run->head.height_px));
  }
  for (const Entry& entry : store->entries(EntryKind::reference)) {
    const auto truth = parse_reference_record(entry.json);
    if (!truth) continue;
    const double samples =
        pixels_of(truth->head.width_px, truth->head.height_px) * truth->head.samples_per_pixel;
    costs.reference_s_per_sample.push_back(truth->head.duration_s / samples);
  }
  return costs;
}

Estimate estimate_run(const Costs& costs, const std::string& technique, const PictureQuality& quality) {
  const double pixels = pixels_of(quality.width_px, quality.height_px);
  const auto found = costs.run_s_per_pixel.find(technique);
  if (found == costs.run_s_per_pixel.end()) return {kRoughRun_s + kRoughRun_s_per_pixel * pixels, 0};
  return {median(found->second) * pixels, found->second.size()};
}

Estimate estimate_reference(const Costs& costs, const PictureQuality& quality) {
  const double samples = pixels_of(quality.width_px, quality.height_px) * quality.samples_per_pixel;
  if (costs.reference_s_per_sample.empty()) return {kRoughReference_s_per_sample * samples, 0};
  return {median(costs.reference_s_per_sample) * samples, costs.reference_s_per_sample.size()};
}

}  // namespace umbrameter
