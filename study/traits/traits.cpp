// SPDX-License-Identifier: Apache-2.0
#include "study/traits/traits.h"

#include "core/hash.h"
#include "lab/score.h"
#include "results/json/json_optional.h"
#include "store/code_hashes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace umbrameter {
namespace {

enum TraitScene : size_t { kContact, kLayers, kHardening, kRound, kSlope, kTerminator };

constexpr float kPenumbraLow = 0.05f;  // reference visibility that counts as penumbra
constexpr float kPenumbraHigh = 0.95f;
constexpr float kGrayLow = 0.02f;  // test visibility that counts as neither lit nor dark
constexpr float kGrayHigh = 0.98f;
constexpr int64_t kSmallMap = 256;  // texels wider than pixels: stairs show

struct Limits {
  double yes = 0.0;
  double partly = 0.0;
  bool more_is_better = false;
};

constexpr std::array<Limits, kTraits> kTraitLimits = {{
    {0.001, 0.005, false},          // precise: mean absolute error that no penumbra explains
    {0.5, 0.2, true},               // soft: share of the penumbra that is neither lit nor dark
    {1.0 / 3.0, 2.0 / 3.0, false},  // anti_aliased: stairs relative to hard
    {0.7, 0.3, true},               // contact_hardening: slope
    {0.0001, 0.005, false},         // acne_free: mean absolute error of class acne
    {0.002, 0.01, false},           // noise_free: mean absolute difference of two seeds
}};

class TraitMeter {
 public:
  TraitMeter(const TraitInputs& inputs, Progress& progress) : inputs_(inputs), progress_(progress) {}

  TechniqueTraits measure(const TechniqueRun& run) {
    TechniqueTraits traits;
    traits.id = run.id;
    const auto set = [&](Trait trait, const std::function<std::optional<double>()>& value) {
      TraitResult& result = traits.results[static_cast<size_t>(trait)];
      try {
        result.value = value();
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled) throw;
        if (traits.failure.empty()) traits.failure = error.what();
      }
      if (result.value) result.verdict = judge(trait, *result.value);
    };
    const auto set_asked = [&](Trait trait, std::optional<double> (TraitMeter::*value)(const TechniqueRun&)) {
      set(trait, [&] { return ask(run, trait, value); });
    };
    set_asked(Trait::precise, &TraitMeter::unexplained);
    set_asked(Trait::soft, &TraitMeter::gray_share);
    set(Trait::anti_aliased, [&] { return relative_stairs(run); });
    set_asked(Trait::contact_hardening, &TraitMeter::hardening_slope);
    set_asked(Trait::acne_free, &TraitMeter::acne_without_bias);
    set_asked(Trait::noise_free, &TraitMeter::seed_noise);
    return traits;
  }

 private:
  std::string key_of(const TechniqueRun& run, Trait trait) const {
    Hasher hasher;
    hasher.text("trait").text(kTraitsCodeHash).text(name_of(trait));
    for (const SceneJob& job : inputs_.scenes) {
      const std::string reference = reference_key(job.scene, inputs_.picture, inputs_.makers);
      hasher.text(run_key(reference, run, inputs_.picture.seed, {}, inputs_.makers));
    }
    return hasher.hex();
  }

  std::optional<double> ask(const TechniqueRun& run, Trait trait,
                            std::optional<double> (TraitMeter::*value)(const TechniqueRun&)) {
    Answers* const answers = inputs_.answers;
    if (answers == nullptr) return (this->*value)(run);
    const std::string key = key_of(run, trait);
    std::optional<double> answer;
    if (answers->find(key, [&](const auto& json) { answer = read_optional<double>(json.at("value")); }))
      return answer;
    answer = (this->*value)(run);
    answers->keep(key, {{"value", optional_json(answer)}});
    return answer;
  }

  Image render(const TechniqueRun& run, TraitScene scene, ParameterValues more = {}, uint64_t seed = 1) {
    RenderRequest request = request_of(inputs_.picture, run, seed);
    for (auto& [name, value] : more) request.parameters[name] = value;
    return inputs_.renderers.realtime.render(inputs_.scenes[scene].scene, request, progress_).image;
  }

  const Image& reference(TraitScene scene) {
    const auto known = references_.find(scene);
    if (known != references_.end()) return known->second;
    Frame frame = inputs_.renderers.reference.render(inputs_.scenes[scene].scene, request_of(inputs_.picture),
                                                     progress_);
    return references_.emplace(scene, std::move(frame.image)).first->second;
  }

  Diagnosis diagnosis(const Image& image, TraitScene scene) {
    const Score score = score_image(image, reference(scene), inputs_.scenes[scene].scene.camera.eye_world);
    if (!score.diagnosis) {
      fail_input(fmt::format("scene '{}' could not be diagnosed: {}", inputs_.scenes[scene].name,
                             score.no_diagnosis ? score.no_diagnosis->message : "the renderers disagree"));
    }
    return *score.diagnosis;
  }

  bool supports(const TechniqueRun& run, TraitScene scene) const {
    return !skip_reason(run, inputs_.scenes[scene].scene);
  }

  std::optional<double> unexplained(const TechniqueRun& run) {
    std::optional<double> worst;
    for (const TraitScene scene : {kContact, kLayers}) {
      if (!supports(run, scene)) continue;
      const FaultNumbers faults = diagnosis(render(run, scene), scene).faults;
      double sum = 0.0;
      for (const FaultClass fault :
           {FaultClass::acne, FaultClass::bleed, FaultClass::geometric_leak, FaultClass::peter_panning})
        sum += faults.of(fault).mean_abs_error;
      worst = std::max(worst.value_or(0.0), sum);
    }
    return worst;
  }

  template <class Count>
  double mean_in_penumbra(TraitScene scene, const Count& count) {
    const auto truth = reference(scene).plane("visibility");
    double sum = 0.0;
    size_t pixels = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] <= kPenumbraLow || truth[i] >= kPenumbraHigh) continue;
      sum += count(i);
      ++pixels;
    }
    return pixels == 0 ? 0.0 : sum / static_cast<double>(pixels);
  }

  std::optional<double> gray_share(const TechniqueRun& run) {
    if (!supports(run, kHardening)) return std::nullopt;
    const Image image = render(run, kHardening);
    const auto v = image.plane("visibility");
    return mean_in_penumbra(kHardening,
                            [&](size_t i) { return v[i] > kGrayLow && v[i] < kGrayHigh ? 1.0 : 0.0; });
  }

  std::optional<double> seed_noise(const TechniqueRun& run) {
    if (!supports(run, kHardening)) return std::nullopt;
    const Image a = render(run, kHardening, {}, 1);
    const Image b = render(run, kHardening, {}, 2);
    const auto va = a.plane("visibility");
    const auto vb = b.plane("visibility");
    return mean_in_penumbra(kHardening, [&](size_t i) { return std::abs(va[i] - vb[i]); });
  }

  /// Standard deviation of the edge's place along a round shadow, in world units.
  std::optional<double> stairs_world(const TechniqueRun& run) {
    if (!supports(run, kRound)) return std::nullopt;
    const Image image = render(run, kRound, small_map(run));
    const Score score = score_image(image, reference(kRound), inputs_.scenes[kRound].scene.camera.eye_world);
    const PenumbraError penumbra = measure_penumbra(image, reference(kRound), score.mask);
    std::vector<double> offsets;
    for (const PenumbraProfile& profile : penumbra.profiles) {
      if (profile.outcome == ProfileOutcome::accepted) offsets.push_back(profile.offset_world);
    }
    if (offsets.size() < kFewestProfiles) return std::nullopt;
    double mean = 0.0;
    for (const double offset : offsets) mean += offset / static_cast<double>(offsets.size());
    double variance = 0.0;
    for (const double offset : offsets)
      variance += (offset - mean) * (offset - mean) / static_cast<double>(offsets.size());
    return std::sqrt(variance);
  }

  static ParameterValues small_map(const TechniqueRun& run) {
    ParameterValues values;
    if (run.parameters.contains("map_size")) values["map_size"] = kSmallMap;
    return values;
  }

  std::optional<double> relative_stairs(const TechniqueRun& run) {
    const std::optional<double> own = ask(run, Trait::anti_aliased, &TraitMeter::stairs_world);
    if (run.id == "hard") hard_stairs_ = own;
    if (!own || !hard_stairs_ || *hard_stairs_ == 0.0) return std::nullopt;
    return *own / *hard_stairs_;
  }

  /// Absent where the technique's penumbrae cannot be measured.
  std::optional<double> hardening_slope(const TechniqueRun& run) {
    if (!supports(run, kHardening)) return std::nullopt;
    return diagnosis(render(run, kHardening), kHardening).contact_hardening.slope;
  }

  std::optional<double> acne_without_bias(const TechniqueRun& run) {
    std::optional<double> worst;
    for (const TraitScene scene : {kSlope, kTerminator}) {
      if (!supports(run, scene)) continue;
      const Image image = render(run, scene, inputs_.neutral_bias(run));
      const double acne = diagnosis(image, scene).faults.of(FaultClass::acne).mean_abs_error;
      worst = std::max(worst.value_or(0.0), acne);
    }
    return worst;
  }

  static constexpr size_t kFewestProfiles = 8;
  const TraitInputs& inputs_;
  Progress& progress_;
  std::map<TraitScene, Image> references_;
  std::optional<double> hard_stairs_;
};

}  // namespace

std::string_view name_of(Trait trait) {
  constexpr std::array<std::string_view, kTraits> names = {"precise",           "soft",      "anti-aliased",
                                                           "contact-hardening", "acne-free", "noise-free"};
  return names[static_cast<size_t>(trait)];
}

std::string_view measure_of(Trait trait) {
  constexpr std::array<std::string_view, kTraits> measures = {
      "mean absolute error of acne, leaks and bleeding, the worse of box_contact and stacked_plates",
      "share of the true penumbra of contact_hardening that is neither lit nor dark",
      "scatter of the edge along disk_occluder's round shadow at a map of 256, relative to hard",
      "slope of log width over log true width on contact_hardening",
      "mean absolute error of acne without any bias, the worse of slanted_plane and sphere_terminator",
      "mean absolute difference of two seeds in the penumbra of contact_hardening"};
  return measures[static_cast<size_t>(trait)];
}

std::string_view symbol_of(TraitVerdict verdict) {
  if (verdict == TraitVerdict::yes) return "Y";
  return verdict == TraitVerdict::partly ? "~" : "N";
}

TraitVerdict judge(Trait trait, double value) {
  const Limits& limits = kTraitLimits[static_cast<size_t>(trait)];
  const double sign = limits.more_is_better ? -1.0 : 1.0;
  if (sign * value <= sign * limits.yes) return TraitVerdict::yes;
  return sign * value <= sign * limits.partly ? TraitVerdict::partly : TraitVerdict::no;
}

std::span<const TraitVerdict> paper_e_claim(std::string_view technique_id) {
  constexpr auto Y = TraitVerdict::yes;
  constexpr auto P = TraitVerdict::partly;
  constexpr auto N = TraitVerdict::no;
  static const std::map<std::string_view, std::array<TraitVerdict, kTraits>> claims = {
      {"hard", {Y, N, N, N, N, Y}}, {"pcf_bilinear", {Y, N, P, N, N, Y}},
      {"pcf", {Y, Y, P, N, N, Y}},  {"pcf_adaptive", {Y, Y, Y, N, N, N}},
      {"vsm", {P, Y, Y, N, Y, N}},  {"pcss", {Y, Y, Y, Y, N, N}},
  };
  const auto found = claims.find(technique_id);
  if (found == claims.end()) return {};
  return found->second;
}

std::span<const std::string> trait_scene_names() {
  static const std::array<std::string, 6> names = {"box_contact",   "stacked_plates", "contact_hardening",
                                                   "disk_occluder", "slanted_plane",  "sphere_terminator"};
  return names;
}

std::vector<TechniqueTraits> measure_traits(std::span<const TechniqueRun> runs, const TraitInputs& inputs,
                                            Progress& progress) {
  UMBRAMETER_ASSERT(inputs.scenes.size() == trait_scene_names().size(), "{} scenes", inputs.scenes.size());
  TraitMeter meter(inputs, progress);
  // `hard` goes first: the others' stairs are told in its.
  std::vector<const TechniqueRun*> order;
  for (const TechniqueRun& run : runs) order.push_back(&run);
  std::ranges::stable_partition(order, [](const TechniqueRun* run) { return run->id == "hard"; });
  std::map<const TechniqueRun*, TechniqueTraits> measured;
  for (const TechniqueRun* run : order) measured.emplace(run, meter.measure(*run));
  std::vector<TechniqueTraits> traits;
  for (const TechniqueRun& run : runs) traits.push_back(std::move(measured.at(&run)));
  return traits;
}

}  // namespace umbrameter
