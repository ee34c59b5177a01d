// SPDX-License-Identifier: Apache-2.0
#pragma once
// A results folder -> one HTML file that needs no network: pictures are inside, numbers carry their context. Only what
// would make it too large to open lies beside it.

#include "report/plane_store.h"
#include "results/results.h"

#include <filesystem>
#include <string>

namespace umbrameter {

/// The page of `results`, whose picture files lie in `folder`, with all pixels inside. Error{input} when one is
/// missing. Every number in the table has its full precision in a data-value attribute.
std::string report_html(const Results& results, const std::filesystem::path& folder);

/// Reads `folder`/results.json and what other verbs left in `beside` (report/side_files.h; empty: in `folder`), and writes
/// `html_file` atomically; pixels beyond the budget go to data_folder(html_file) before it. Without results.json the page
/// is of the runs in the folder's store (a sweep's), or of the others alone. `before`: an earlier results folder whose runs stand
/// beside those of now (report/before.h). Error{input} for a malformed file, or when there is none.
void write_report(const std::filesystem::path& folder, const std::filesystem::path& html_file,
                  size_t budget_bytes = kPageBudget_bytes, const std::filesystem::path& beside = {},
                  const std::filesystem::path& before = {});

/// report.html -> report-data.
std::filesystem::path data_folder(const std::filesystem::path& html_file);

}  // namespace umbrameter
