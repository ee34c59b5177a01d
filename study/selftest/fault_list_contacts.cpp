// SPDX-License-Identifier: Apache-2.0
// Faults where objects touch and on real models: there softness, bias and resolution meet in one place.
#include "study/selftest/trial_makers.h"

namespace umbrameter {
namespace {

using enum GateClass;
using Kinds = std::vector<GateClass>;

constexpr auto kTechnique = FaultOrigin::technique;
constexpr auto kImage = FaultOrigin::image;

FaultCase filter_too_wide(const std::string& scene) {
  return {"filter four times too wide",
          kTechnique,
          scene,
          {penumbra_too_wide},
          changed(fixed_filter(), {{"radius_texels", 32.0}})};
}

FaultCase variance_too_wide(const std::string& scene) {
  return {"variance filter five times too wide",
          kTechnique,
          scene,
          {penumbra_too_wide},
          changed(variance_shadows(), {{"filter_width_texels", 45.0}})};
}

FaultCase light_twice(const std::string& scene) {
  return {"light twice too large",
          kTechnique,
          scene,
          {penumbra_too_wide},
          of_scene(soft_shadows(), light_scaled(2.0))};
}

FaultCase light_half(const std::string& scene) {
  return {"light half too small", kTechnique, scene, {softness}, of_scene(soft_shadows(), light_scaled(0.5))};
}

FaultCase picture_blurred(const std::string& scene) {
  return {"picture blurred", kImage, scene, {penumbra_too_wide}, painted(soft_shadows(), picture_blur)};
}

FaultCase map_too_coarse(const std::string& scene, int64_t map_size = 128) {
  return {
      "map too coarse", kTechnique, scene, {resolution}, changed(soft_shadows(), {{"map_size", map_size}})};
}

FaultCase caster_below_a_texel(const std::string& scene, int64_t map_size) {
  return {"caster thinner than a texel",
          kTechnique,
          scene,
          {resolution},
          changed(choice("hard"), {{"map_size", map_size}})};
}

FaultCase bias_gone(const std::string& scene) {
  return {"bias x 0",
          kTechnique,
          scene,
          {acne},
          changed(biased_shadows(), {{"bias_texels", 0.0}, {"normal_offset_texels", 0.0}})};
}

FaultCase bias_too_large(const std::string& scene, double bias_texels) {
  return {"bias too large",
          kTechnique,
          scene,
          {peter_panning},
          changed(biased_shadows(), {{"bias_texels", bias_texels}})};
}

FaultCase cured_terminator(const std::string& scene) {
  return {"terminator cured", kImage, scene, {terminator}, painted(soft_shadows(), terminator_cured)};
}

FaultCase gap_at_contacts(const std::string& scene) {
  return {"gap of 4 px at contacts", kImage, scene, {peter_panning}, painted(soft_shadows(), contact_gap)};
}

FaultCase slit(const std::string& scene) {
  return {"light-leak slit, 3 px", kImage, scene, {geometric_leak}, painted(soft_shadows(), light_leak_slit)};
}

FaultCase speckled(const std::string& scene) {
  return {"speckle in .2 % of pixels", kImage, scene, {acne}, painted(soft_shadows(), speckle)};
}

FaultCase striped(const std::string& scene) {
  return {"moire, a quarter dark", kImage, scene, {acne}, painted(soft_shadows(), stripes)};
}

FaultCase few_taps(const std::string& scene) {
  return {
      "few taps, noise", kTechnique, scene, {noise}, changed(soft_shadows(), {{"filter_taps", int64_t{4}}})};
}

FaultCase other_light(const std::string& scene) {
  return {"lit from elsewhere", FaultOrigin::reference, scene, {light}, against_truth([](Stage& stage) {
            return stage.truth_of(with_light_moved(stage.scene(), 0.3), stage.seed());
          })};
}

}  // namespace

std::vector<FaultCase> faults_at_contacts() {
  return {filter_too_wide("box_contact"),
          filter_too_wide("colonnade"),
          filter_too_wide("contact_hardening"),
          variance_too_wide("box_contact"),
          variance_too_wide("colonnade"),
          light_twice("contact_hardening"),
          light_twice("colonnade"),
          light_half("contact_hardening"),
          picture_blurred("box_contact"),
          picture_blurred("fence"),
          map_too_coarse("fence"),
          map_too_coarse("box_contact"),
          caster_below_a_texel("wire", 64),
          caster_below_a_texel("fence", 128),
          {"hardens the wrong end", kTechnique, "contact_hardening", {hardening}, hardening_inverted()},
          {"constant width", kTechnique, "contact_hardening", {hardening}, hardening_absent()},
          bias_gone("colonnade"),
          bias_too_large("fence", 32.0),  // a closed box's map holds its lit faces, far from where it stands
          cured_terminator("sphere_terminator"),
          gap_at_contacts("colonnade"),
          striped("colonnade"),
          speckled("fence"),
          slit("box_contact"),
          few_taps("contact_hardening"),
          other_light("box_contact")};
}

std::vector<FaultCase> faults_of_models() {
  return {filter_too_wide("assets/bunny"),
          filter_too_wide("assets/crytek_sponza"),
          variance_too_wide("assets/dragon"),
          light_twice("assets/bunny"),
          light_half("assets/dabrovic_sponza"),
          picture_blurred("assets/conference"),
          map_too_coarse("assets/crytek_sponza"),
          map_too_coarse("assets/bunny", 64),
          bias_gone("assets/bunny"),
          bias_too_large("assets/dragon", 12.0),
          cured_terminator("assets/bunny"),
          gap_at_contacts("assets/country_kitchen"),
          slit("assets/crytek_sponza"),
          speckled("assets/conference"),
          striped("assets/temple"),
          few_taps("assets/columns"),
          other_light("assets/dragon")};
}

}  // namespace umbrameter
