// SPDX-License-Identifier: Apache-2.0
#pragma once
// What tuning each light of a scene is worth for all of them together: the lit picture, the sum over lights of visibility times
// unshadowed irradiance, against the truth's sum of irradiance (metrics/error/lit_error.h).

#include "metrics/error/lit_sum.h"
#include "study/tune/tune.h"

#include <optional>
#include <span>
#include <string>

namespace umbrameter {

/// A light's scene job with the plan and result of its tuning.
struct TunedLight {
  SceneJob* job = nullptr;
  const TunePlan* plan = nullptr;
  const TuneResult* result = nullptr;
};

/// The same of a scene's lights from its own camera, at full size.
std::optional<LitSum> judge_lit_sum(const std::string& scene, std::span<const TunedLight> lights,
                                    Renderer& realtime, Progress& progress);

}  // namespace umbrameter
