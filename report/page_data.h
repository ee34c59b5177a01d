// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers behind the page's pictures and plots, as one JSON object for its scripts.

#include "report/plane_store.h"
#include "results/results.h"

#include <filesystem>
#include <optional>
#include <string>

namespace umbrameter {

/// {results, texts, scenes, bias_sweeps, tunings, palette, data_folder, and side_data's}: results.json itself (empty without
/// `results`, and texts null), page_texts, how to read the planes (of pictures in `folder`; they go into `store`), what other verbs
/// left in `beside`, colours and scales. Compact, and safe inside a <script>.
std::string page_data(const std::optional<Results>& results, const std::filesystem::path& folder,
                      const std::filesystem::path& beside, PlaneStore& store);

/// `json` with every < as an escape, so that nothing in it can end the script it stands in.
std::string script_safe(std::string json);

}  // namespace umbrameter
