// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers behind the page's pictures and plots, as one JSON object for its scripts.

#include "report/plane_store.h"
#include "study/results.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace umbrameter {

/// {results, scenes, bias_sweeps, benches, palette, data_folder}: results.json itself, how to read the planes (of pictures in
/// `folder`; they go into `store`), what `tune` left in `beside`, the plots of bench_part, colours and scales. Compact, and
/// safe inside a <script>.
std::string page_data(const Results& results, const std::filesystem::path& folder,
                      const std::filesystem::path& beside, const nlohmann::ordered_json& benches,
                      PlaneStore& store);

/// `json` with every < as an escape, so that nothing in it can end the script it stands in.
std::string script_safe(std::string json);

}  // namespace umbrameter
