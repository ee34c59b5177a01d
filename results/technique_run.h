// SPDX-License-Identifier: Apache-2.0
#pragma once
// One technique with one parameter set, as chosen by the user.

#include "core/parameters.h"
#include "results/picture_quality.h"
#include "scenes/light.h"

#include <string>
#include <vector>

namespace umbrameter {

struct TechniqueRun {
  std::string technique;  // RenderRequest::technique: id or folder
  std::string id;
  std::string label;  // unique in the plan
  std::string title;
  std::string hash;
  ParameterValues parameters;
  std::vector<LightType> lights;  // supported
  std::string only_light = {};    // the name of the light that the parameters are for; empty: any
  /// Those that act with these values: what lab/causes/ may replace. None for an engine.
  std::vector<Parameter> declared = {};
};

/// The run's picture, of its own seed.
inline RenderRequest request_of(const PictureQuality& picture, const TechniqueRun& run, uint64_t seed) {
  RenderRequest request = request_of(picture);
  request.seed = seed;
  request.technique = run.technique;
  request.parameters = run.parameters;
  return request;
}

}  // namespace umbrameter
