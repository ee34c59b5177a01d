// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/fault_list.h"

#include "study/selftest/trial_makers.h"

#include <array>
#include <utility>

namespace umbrameter {
namespace {

using enum GateClass;

const TechniqueChoice kSoft = soft_shadows();
const TechniqueChoice kBiased = biased_shadows();
const TechniqueChoice kFixed = fixed_filter();
const TechniqueChoice kVariance = variance_shadows();
const TechniqueChoice kWarped = choice("evsm", {{"filter_width_texels", 9.0}});
const TechniqueChoice kExponential = choice("esm", {{"filter_width_texels", 3.0}});

Image one_seed_for_both_halves(Stage& stage) {
  Image truth = stage.truth();
  truth.planes["half_b"] = truth.planes["half_a"];
  truth.planes["visibility"] = truth.planes["half_a"];
  return truth;
}

VisibilityError swapped_operands(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  Image swapped_test = test, swapped_reference = reference;
  std::swap(swapped_test.planes["visibility"], swapped_reference.planes["visibility"]);
  return measure_visibility_error(swapped_test, swapped_reference, mask);
}

VisibilityError forgotten_mask(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  return measure_visibility_error(test, reference, std::vector<uint8_t>(mask.size(), 1));
}

VisibilityError mae_for_mse(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  VisibilityError error = measure_visibility_error(test, reference, mask);
  if (error.mse) error.mse->value = *error.mae;
  return error;
}

VisibilityError noise_as_error(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  Image no_halves = reference;
  no_halves.planes["half_a"] = no_halves.planes["half_b"] = reference.planes.at("visibility");
  return measure_visibility_error(test, no_halves, mask);
}

std::vector<FaultCase> faults_of_techniques() {
  constexpr auto kOrigin = FaultOrigin::technique;
  const auto text = [](const char* t) { return ParameterValue(std::string(t)); };
  return {
      {"bias x 0",
       kOrigin,
       "box_contact",
       {acne},
       changed(kBiased, {{"bias_texels", 0.0}, {"normal_offset_texels", 0.0}})},
      {"bias x 0, slope",
       kOrigin,
       "slanted_plane",
       {acne},
       changed(kBiased, {{"bias_texels", 0.0}, {"normal_offset_texels", 0.0}})},
      {"bias x 10",
       kOrigin,
       "colonnade",
       {peter_panning},
       changed(with(kBiased, {{"bias_world", 0.03}}), {{"bias_world", 0.3}})},
      {"normal offset x 10",
       kOrigin,
       "colonnade",
       {offset, peter_panning},
       changed(kBiased, {{"normal_offset_texels", 10.0}})},
      {"light's radius for its diameter", kOrigin, "plate", {softness}, of_scene(kSoft, light_scaled(0.5))},
      {"light's diameter for its radius",
       kOrigin,
       "half_plane_disk",
       {penumbra_too_wide},
       of_scene(kSoft, light_scaled(2.0))},
      {"softer in one half", kOrigin, "half_plane", {penumbra_too_wide}, softer_half},
      {"hardens the wrong end", kOrigin, "sphere_terminator", {hardening}, hardening_inverted()},
      {"constant width", kOrigin, "sphere_terminator", {hardening}, hardening_absent()},
      {"kernel in texels, not in the world",
       kOrigin,
       "half_plane",
       {softness},
       changed(with(kFixed, {{"radius_texels", 32.0}}), {{"map_size", int64_t{4096}}})},
      {"hard for soft", kOrigin, "plate", {softness}, instead(kSoft, choice("hard"))},
      {"search radius too small",
       kOrigin,
       "half_plane_disk",
       {softness},
       patched(kSoft, "search",
               {{"blocker_search.glsl", "vec2 kernel = focused(", "vec2 kernel = 0.1 * focused("}})},
      {"few taps, noise", kOrigin, "half_plane", {noise}, changed(kSoft, {{"filter_taps", int64_t{4}}})},
      {"few taps, no noise",
       kOrigin,
       "half_plane",
       {banding},
       changed(kSoft, {{"filter_taps", int64_t{6}}, {"noise", false}})},
      {"map of an eighth", kOrigin, "colonnade", {resolution}, changed(kSoft, {{"map_size", int64_t{128}}})},
      {"culls the wrong faces",
       kOrigin,
       "plate",
       {lost_shadow},
       changed(kSoft, {{"caster_layer", text("back_faces")}})},
      {"missing caster",
       kOrigin,
       "stacked_plates",
       {geometric_leak, lost_shadow},
       of_scene(kSoft, without("lower"))},
      {"thin caster missing", kOrigin, "contact_hardening", {lost_shadow}, of_scene(kSoft, without("bar"))},
      {"no bleed reduction",
       kOrigin,
       "stacked_plates",
       {bleed},
       changed(kVariance, {{"bleed_reduction", 0.0}})},
      {"exponent overflows",
       kOrigin,
       "plate",
       {lost_shadow},
       patched(kExponential, "overflow",
               {{"technique.toml", "constraints = [\"exponent <= 80 || form != form.exponential\"]\n", ""}},
               {{"exponent", 1000.0}})},
      {"warped moments in half floats",
       kOrigin,
       "plate",
       {extra_shadow},
       patched(kWarped, "half_floats",
               {{"technique.toml", "name = \"moments\"\nformat = \"rgba32f\"",
                 "name = \"moments\"\nformat = \"rgba16f\""},
                {"technique.toml", "name = \"moments_x\"\nformat = \"rgba32f\"",
                 "name = \"moments_x\"\nformat = \"rgba16f\""}})},
      {"map depth in 8 bits",
       kOrigin,
       "box_contact",
       {acne},
       patched(choice("hard"), "eight_bits",
               {{"shadow_map.glsl", "texelFetch(map, texel, 0).r, z_blocker)",
                 "ceil(255.0 * texelFetch(map, texel, 0).r) / 255.0, z_blocker)"}})},
      {"map upside down",
       kOrigin,
       "box_contact",
       {lost_shadow, extra_shadow},
       patched(kSoft, "upside_down",
               {{"shadow_map.glsl", "return ivec2(floor(texel_position(view, lateral)));",
                 "ivec2 t = ivec2(floor(texel_position(view, lateral))); return ivec2(t.x, "
                 "int(view.depth_range.w) - 1 - t.y);"}})},
      {"map one frame late", kOrigin, "half_plane", {offset}, of_scene(kSoft, light_moved(0.05))},
  };
}

std::vector<FaultCase> faults_of_images() {
  constexpr auto kOrigin = FaultOrigin::image;
  return {
      {"light-leak slit, 3 px", kOrigin, "half_plane", {geometric_leak}, painted(kSoft, light_leak_slit)},
      {"speckle in .2 % of pixels", kOrigin, "plate", {acne}, painted(kSoft, speckle)},
      {"moire, a quarter dark", kOrigin, "contact_hardening", {acne}, painted(kSoft, stripes)},
      {"gap of 4 px at contacts", kOrigin, "box_contact", {peter_panning}, painted(kSoft, contact_gap)},
      {"bleeding of .15", kOrigin, "stacked_plates", {bleed}, painted(kSoft, bleeding)},
      {"thin shadow lost", kOrigin, "contact_hardening", {lost_shadow}, exact_of(without("post"))},
  };
}

std::vector<FaultCase> faults_of_references() {
  constexpr auto kOrigin = FaultOrigin::reference;
  return {
      {"light faces another way", kOrigin, "plate", {light}, against_truth([](Stage& stage) {
         return stage.truth_of(with_light_turned(stage.scene(), 0.6), stage.seed());
       })},
      {"light of half the size",
       kOrigin,
       "half_plane",
       {penumbra_too_wide},
       against_shadows_of(light_scaled(0.5))},
      {"only the light's centre", kOrigin, "plate", {truth}, against_shadows_of(light_scaled(1e-4))},
      {"one seed for both halves", kOrigin, "half_plane", {truth}, against_truth(one_seed_for_both_halves)},
      {"culls casters' lit faces",
       kOrigin,
       "plate",
       {extra_shadow},
       against_shadows_of([](const Scene& scene) { return without_faces_to_light(scene, "floor"); })},
  };
}

std::vector<FaultCase> faults_of_metrics() {
  constexpr auto kOrigin = FaultOrigin::metric;
  return {{"operands swapped", kOrigin, "plate", {metric}, measured_by(swapped_operands)},
          {"mask forgotten", kOrigin, "plate", {metric}, measured_by(forgotten_mask)},
          {"MAE for MSE", kOrigin, "plate", {metric}, measured_by(mae_for_mse)},
          {"noise counted as error", kOrigin, "plate", {metric}, measured_by(noise_as_error)}};
}

}  // namespace

std::vector<FaultCase> fault_list() {
  std::vector<FaultCase> all;
  for (std::vector<FaultCase> part : {faults_of_techniques(), faults_of_images(), faults_of_references(),
                                      faults_of_metrics(), faults_at_contacts(), faults_of_models()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace umbrameter
