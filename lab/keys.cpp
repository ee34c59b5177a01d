// SPDX-License-Identifier: Apache-2.0
#include "lab/keys.h"

#include "core/files.h"
#include "core/hash.h"
#include "store/code_hashes.h"

#include <map>

namespace umbrameter {
namespace {

/// 1, 1.0 and "1" differ; booleans are numbers, which no other value of their parameter is.
void add(const ParameterValues& parameters, Hasher& hasher) {
  for (const auto& [name, value] : parameters) {
    hasher.text(name).number(static_cast<double>(value.index()));
    if (const auto* text = std::get_if<std::string>(&value)) hasher.text(*text);
    if (const auto* real = std::get_if<double>(&value)) hasher.number(*real);
    if (const auto* integer = std::get_if<int64_t>(&value)) hasher.bytes(integer, sizeof *integer);
    if (const auto* flag = std::get_if<bool>(&value)) hasher.number(*flag ? 1.0 : 0.0);
  }
}

}  // namespace

std::string reference_key(const Scene& scene, const PictureQuality& picture, const Makers& makers,
                          bool skip_proven) {
  return reference_key(scene.hash, scene.active_light, picture, makers, skip_proven);
}

std::string reference_key(const std::string& scene_hash, size_t active_light, const PictureQuality& picture,
                          const Makers& makers, bool skip_proven) {
  Hasher hasher;
  hasher.text("reference").text(kReferenceCodeHash).text(makers.reference);
  hasher.text(scene_hash).number(static_cast<double>(active_light));
  hasher.number(picture.width_px).number(picture.height_px).number(picture.samples_per_pixel);
  hasher.number(picture.target_se.value_or(-1.0));  // no standard error is negative
  if (!skip_proven) hasher.text("every pixel is sampled");
  return hasher.bytes(&picture.seed, sizeof picture.seed).hex();
}

std::string run_key(const std::string& reference, const TechniqueRun& run, uint64_t seed,
                    const MetricChoice& metrics, const Makers& makers) {
  Hasher hasher;
  hasher.text("run").text(kRealtimeCodeHash).text(kScoringCodeHash).text(reference);
  hasher.text(makers.realtime).text(makers.shaders).text(run.hash);
  hasher.bytes(&seed, sizeof seed);
  for (const bool chosen : {metrics.significance, metrics.diagnosis, metrics.similarity})
    hasher.number(chosen ? 1.0 : 0.0);
  add(run.parameters, hasher);
  return hasher.hex();
}

std::string frame_key(const std::string& scene_hash, size_t active_light, const RenderRequest& request,
                      const std::string& technique_hash, const Makers& makers) {
  Hasher hasher;
  hasher.text("frame").text(kRealtimeCodeHash).text(makers.realtime).text(makers.shaders);
  hasher.text(scene_hash).number(static_cast<double>(active_light));
  hasher.number(request.width_px).number(request.height_px).text(technique_hash);
  hasher.bytes(&request.seed, sizeof request.seed);
  add(request.parameters, hasher);
  return hasher.hex();
}

std::string moved_run_key(const std::string& run, const std::string& motion) {
  return motion.empty() ? run : Hasher().text("moved").text(run).text(motion).hex();
}

std::string parity_key(const std::string& reference, const Makers& makers) {
  Hasher hasher;
  hasher.text("parity").text(kRealtimeCodeHash).text(kScoringCodeHash).text(reference);
  return hasher.text(makers.realtime).text(makers.shaders).hex();
}

std::string validated_run_key(const std::string& run, const ValidationPlan& plan) {
  Hasher hasher;
  hasher.text("validated").text(run).number(plan.timed_frames).number(plan.timing_budget_s);
  hasher.number(plan.temporal_frames).number(plan.limit_rmse.value_or(-1.0));  // no limit is negative
  for (const bool chosen : {plan.maps, plan.skip}) hasher.number(chosen ? 1.0 : 0.0);
  return hasher.hex();
}

std::string validated_note_key(const std::string& run) {
  return Hasher().text("validated note").text(run).hex();
}

std::string verdict_key(const std::string& run, const std::string& baseline) {
  return Hasher().text("verdict").text(run).text(baseline).hex();
}

std::string causes_key(const std::string& run) {
  return Hasher().text("causes").text(run).hex();
}

std::string hash_folder(const std::filesystem::path& folder) {
  std::map<std::string, std::filesystem::path> by_name;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      by_name[entry.path().lexically_relative(folder).generic_string()] = entry.path();
  }
  Hasher hasher;
  for (const auto& [name, file] : by_name) hasher.text(name).text(read_file(file));
  return hasher.hex();
}

}  // namespace umbrameter
