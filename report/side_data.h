// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `bench`, `stress` and `regress` left beside the results, for the page's scripts, which draw it.

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace umbrameter {

/// {benches, stresses, regressions}: the studies of every bench*.json in `folder`, every stress*.json and regress*.json, as
/// those verbs print them (docs/studies.md, stress.md, regress.md), each with `file`; breaks and cells of a stress run with
/// `words` for people. Error{input} naming the file when something that the page shows is missing or of another type.
nlohmann::ordered_json side_data(const std::filesystem::path& folder);

}  // namespace umbrameter
