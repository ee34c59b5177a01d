// SPDX-License-Identifier: Apache-2.0
#pragma once
// The schema of every JSON file that the program reads again (docs/results.md has the list). A number grows when a reader of the
// older files would be wrong; more keys are no new schema.

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace umbrameter {

struct FileSchema {
  const char* what;  // a file of it: "bench"
  int number;
  const char* again;  // how to make one of this version
};

inline constexpr FileSchema kResultsSchema = {"results", 4, "run 'umbrameter validate' again"};
inline constexpr FileSchema kBenchSchema = {"bench", 2, "run 'umbrameter bench' again"};
inline constexpr FileSchema kTuneSchema = {"tune", 1, "run 'umbrameter tune' again"};
inline constexpr FileSchema kRegressSchema = {"regress", 1, "run 'umbrameter regress check' again"};
inline constexpr FileSchema kStressSchema = {"stress", 1, "run 'umbrameter stress' again"};

// Of answers that nothing of ours reads again.
inline constexpr int kExportSchema = 1;
inline constexpr int kSweepSchema = 1;
inline constexpr int kSelftestSchema = 1;
inline constexpr int kAnswerSchema = 1;  // of every other verb's --json

/// Error{input} with number, file and hint unless `document` says that it has this schema; an exception of the library's where
/// it says none.
template <class Json>
void require_schema(const Json& document, const FileSchema& schema, const std::string& file) {
  const int number = document.at("schema").template get<int>();
  if (number == schema.number) return;
  fail_input(fmt::format("{} of schema {}; this version reads {}", schema.what, number, schema.number),
             {file}, schema.again);
}

}  // namespace umbrameter
