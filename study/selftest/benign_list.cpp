// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/scene_change.h"
#include "study/selftest/fault_list.h"
#include "study/selftest/injection.h"

#include <utility>

namespace umbrameter {
namespace {

const TechniqueChoice kBenignSoft = soft_shadows();

Trial against_soft(Image picture) {
  Trial trial;
  trial.picture = std::move(picture);
  trial.baseline = kBenignSoft;
  return trial;
}

MakeTrial other_parameters(const ParameterValues& parameters) {
  return [parameters](Stage& stage) { return against_soft(stage.picture(with(kBenignSoft, parameters))); };
}

MakeTrial painted_on_exact(Injected (*paint)(const Canvas&)) {
  return [paint](Stage& stage) {
    Injected injected = paint({stage.exact(), stage.truth(), stage.examined_exact().mask});
    Trial trial;
    trial.picture = std::move(injected.picture);
    trial.injected = std::move(injected.pixels);
    return trial;
  };
}

Trial other_truth(Stage& stage) {
  Trial trial = against_soft(stage.picture(kBenignSoft, stage.seed() + 1));
  trial.truth = stage.exact();
  return trial;
}

Trial other_threads(Stage& stage) {
  Trial trial;
  trial.picture = stage.exact();
  trial.truth = stage.truth_with_other_threads();
  return trial;
}

Trial exact(Stage& stage) {
  Trial trial;
  trial.picture = stage.exact();
  return trial;
}

Trial with_jitter(Stage& stage) {
  const Image& picture = stage.picture(kBenignSoft);
  return against_soft(jitter({picture, stage.truth(), stage.examined(kBenignSoft).mask}).picture);
}

// Where no blocker but the receiver's own plane cuts the larger light there is no penumbra to widen.
Trial with_larger_light(Stage& stage) {
  Trial trial;
  trial.picture = stage.truth_of_shadows(with_light_scaled(stage.scene(), 1.1));
  const std::span<float> v = trial.picture.plane("visibility");
  const std::span<const float> layers = std::as_const(trial.picture).plane("blocker_layers");
  for (size_t i = 0; i < v.size(); ++i) {
    if (layers[i] == 0.0f) v[i] = stage.exact().plane("visibility")[i];
  }
  return trial;
}

// So little of the light's distance moves shadows by less than a texel of the map.
Trial with_light_nudged(Stage& stage) {
  return against_soft(stage.picture_of_shadows(kBenignSoft, with_light_moved(stage.scene(), 5e-4)));
}

}  // namespace

std::vector<BenignVariant> benign_list() {
  return {{"exact, with noise", exact},
          {"other thread count", other_threads},
          {"other seed", other_truth},
          {"jitter of 1/255", with_jitter},
          {"penumbrae 10 % wider", with_larger_light},
          {"shift below a texel", with_light_nudged, true},
          {"map twice as fine", other_parameters({{"map_size", int64_t{2048}}}), true},
          {"map on a grid", other_parameters({{"map_snap", true}}), true},
          {"twice the taps", other_parameters({{"filter_taps", int64_t{128}}})}};
}

std::vector<MaskCase> mask_list() {
  return {{"speckle in the open", FaultClass::acne, painted_on_exact(speckle_in_the_open)},
          {"stripes in the open", FaultClass::acne, painted_on_exact(stripes_in_the_open)},
          {"leak slit", FaultClass::geometric_leak, painted_on_exact(light_leak_slit)},
          {"speckle anywhere lit", FaultClass::acne, painted_on_exact(speckle)},
          {"stripes anywhere lit", FaultClass::acne, painted_on_exact(stripes)}};
}

}  // namespace umbrameter
