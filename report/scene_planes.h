// SPDX-License-Identifier: Apache-2.0
#pragma once
// One scene's pixels for the page, and the JSON that says how to read them.

#include "report/plane_store.h"
#include "results/results.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace umbrameter {

/// Packs the scene's reference and runs into `store` under the ids `s<scene>` and `s<scene>-r<run>`, counted from 0.
/// Returns {id, width, height, planes, small, runs}; `planes` is name -> {low, step, delta} or {bytes: true}, `small` the
/// picture at the head of the page with its planes inside, and a run is null when it left no picture, else {id, planes,
/// widths, profiles}. Null without a reference. Error{input} when a file that the results name is missing.
nlohmann::ordered_json add_scene_planes(const SceneResult& scene, size_t scene_index,
                                        const std::filesystem::path& folder, PlaneStore& store);

}  // namespace umbrameter
