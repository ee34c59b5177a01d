// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ways to make a trial of a fault: other parameters, a patched technique, a changed scene, paint. Not here: which faults
// there are (study/selftest/fault_list.cpp, fault_list_contacts.cpp).

#include "scenes/altered/scene_change.h"
#include "study/selftest/fault_list.h"
#include "study/selftest/injection.h"
#include "study/selftest/mutant.h"

#include <functional>
#include <string>
#include <vector>

namespace umbrameter {

using SceneChange = std::function<Scene(const Scene&)>;

/// On a map of 1024.
TechniqueChoice choice(const std::string& technique, const ParameterValues& parameters = {});
/// soft_shadows() biased as maps are without a receiver plane.
TechniqueChoice biased_shadows();
/// A disk of 8 texels everywhere.
TechniqueChoice fixed_filter();
TechniqueChoice variance_shadows();

/// A picture that cannot be made is a trial, too.
Trial trial_of(const TechniqueChoice& baseline, const std::function<Image()>& render);
MakeTrial instead(const TechniqueChoice& baseline, const TechniqueChoice& wrong);
MakeTrial changed(const TechniqueChoice& baseline, const ParameterValues& parameters);
MakeTrial patched(const TechniqueChoice& baseline, const std::string& name, const std::vector<Patch>& patches,
                  const ParameterValues& parameters = {});
/// The shadows of a changed scene.
MakeTrial of_scene(const TechniqueChoice& baseline, const SceneChange& change);
MakeTrial painted(const TechniqueChoice& baseline, Injected (*paint)(const Canvas&));
/// A correct picture of a wrong scene.
MakeTrial exact_of(const SceneChange& change);
MakeTrial against_truth(const std::function<Image(Stage&)>& truth);
MakeTrial against_shadows_of(const SceneChange& change);
MakeTrial measured_by(const ErrorMetric& metric);

SceneChange light_scaled(double factor);
SceneChange light_moved(double share);
SceneChange without(const std::string& part);

/// soft_shadows() with its penumbra's size taken from the wrong end, or from no end at all.
MakeTrial hardening_inverted();
MakeTrial hardening_absent();
/// Twice the light in the picture's left half: Unity's fault of that kind left one cascade too soft.
Trial softer_half(Stage& stage);

/// Of other files: part of fault_list().
std::vector<FaultCase> faults_at_contacts();
std::vector<FaultCase> faults_of_models();

}  // namespace umbrameter
