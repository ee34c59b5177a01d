// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/trial_makers.h"

#include "core/guard.h"

#include <utility>

namespace umbrameter {

TechniqueChoice choice(const std::string& technique, const ParameterValues& parameters) {
  return with({technique, {{"map_size", int64_t{1024}}}}, parameters);
}

TechniqueChoice soft_shadows() {
  return choice("pcss", {{"search_taps", int64_t{32}}, {"filter_taps", int64_t{64}}});
}

TechniqueChoice biased_shadows() {
  return with(soft_shadows(),
              {{"receiver_plane", std::string("none")}, {"bias_texels", 1.0}, {"normal_offset_texels", 1.0}});
}

TechniqueChoice fixed_filter() {
  return choice("pcf_disk", {{"taps", int64_t{64}}, {"radius_texels", 8.0}});
}

TechniqueChoice variance_shadows() {
  return choice("vsm", {{"filter_width_texels", 9.0}, {"bleed_reduction", 0.3}});
}

Trial trial_of(const TechniqueChoice& baseline, const std::function<Image()>& render) {
  Trial trial;
  trial.baseline = baseline;
  trial.failure = guarded([&] { trial.picture = render(); });
  return trial;
}

MakeTrial instead(const TechniqueChoice& baseline, const TechniqueChoice& wrong) {
  return [=](Stage& stage) { return trial_of(baseline, [&] { return stage.picture(wrong); }); };
}

MakeTrial changed(const TechniqueChoice& baseline, const ParameterValues& parameters) {
  return instead(baseline, with(baseline, parameters));
}

MakeTrial patched(const TechniqueChoice& baseline, const std::string& name, const std::vector<Patch>& patches,
                  const ParameterValues& parameters) {
  return [=](Stage& stage) {
    const TechniqueChoice wrong = mutant(with(baseline, parameters), name, patches, stage.settings());
    return trial_of(baseline, [&] { return stage.picture(wrong); });
  };
}

MakeTrial of_scene(const TechniqueChoice& baseline, const SceneChange& change) {
  return [=](Stage& stage) {
    return trial_of(baseline, [&] { return stage.picture_of_shadows(baseline, change(stage.scene())); });
  };
}

MakeTrial painted(const TechniqueChoice& baseline, Injected (*paint)(const Canvas&)) {
  return [=](Stage& stage) {
    const Image& picture = stage.picture(baseline);
    Injected injected = paint({picture, stage.truth(), stage.examined(baseline).mask});
    Trial trial = trial_of(baseline, [&] { return std::move(injected.picture); });
    trial.injected = std::move(injected.pixels);
    return trial;
  };
}

MakeTrial exact_of(const SceneChange& change) {
  return [=](Stage& stage) {
    Trial trial;
    trial.picture = stage.truth_of_shadows(change(stage.scene()));
    return trial;
  };
}

MakeTrial against_truth(const std::function<Image(Stage&)>& truth) {
  return [=](Stage& stage) {
    Trial trial = trial_of(soft_shadows(), [&] { return stage.picture(soft_shadows()); });
    trial.truth = truth(stage);
    return trial;
  };
}

MakeTrial against_shadows_of(const SceneChange& change) {
  return against_truth([=](Stage& stage) { return stage.truth_of_shadows(change(stage.scene())); });
}

MakeTrial measured_by(const ErrorMetric& metric) {
  return [=](Stage& stage) {
    Trial trial = trial_of(soft_shadows(), [&] { return stage.picture(soft_shadows()); });
    trial.metric = metric;
    return trial;
  };
}

SceneChange light_scaled(double factor) {
  return [=](const Scene& scene) { return with_light_scaled(scene, factor); };
}

SceneChange light_moved(double share) {
  return [=](const Scene& scene) { return with_light_moved(scene, share); };
}

SceneChange without(const std::string& part) {
  return [=](const Scene& scene) { return without_part(scene, part); };
}

MakeTrial hardening_inverted() {
  return patched(
      soft_shadows(), "inverted",
      {{"pcss.frag", "visible_share(light, receiver, z_blocker,",
        "visible_share(light, receiver, view_light.depth_range.x + receiver.p_light.z - z_blocker,"}});
}

MakeTrial hardening_absent() {
  return patched(soft_shadows(), "constant",
                 {{"pcss.frag", "visible_share(light, receiver, z_blocker,",
                   "visible_share(light, receiver, 0.7 * receiver.p_light.z,"}});
}

Trial softer_half(Stage& stage) {
  const Image soft = stage.picture_of_shadows(soft_shadows(), with_light_scaled(stage.scene(), 2.0));
  Trial trial = trial_of(soft_shadows(), [&] { return stage.picture(soft_shadows()); });
  const std::span<float> v = trial.picture.plane("visibility");
  const size_t width = static_cast<size_t>(trial.picture.width);
  for (size_t i = 0; i < v.size(); ++i) {
    if (i % width < width / 2) v[i] = soft.plane("visibility")[i];
  }
  return trial;
}

}  // namespace umbrameter
