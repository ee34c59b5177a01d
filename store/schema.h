// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tables of store.sqlite, and what is done when they are damaged. Described in docs/store.md.

#include "store/database.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// Makes the tables when there are none. Error{input} for another schema.
void require_schema(Database& database, Database::Mode mode, const std::filesystem::path& file);

/// Checks the database before it is opened, one process at a time; sets a damaged one aside and makes a new one of
/// the rows that can be read. Adds what happened to `warnings`.
void repair_if_damaged(const std::filesystem::path& folder, std::vector<std::string>& warnings);

}  // namespace umbrameter
