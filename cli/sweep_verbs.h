// SPDX-License-Identifier: Apache-2.0
#pragma once
// The verbs of sweeps and of the stores they fill.

#include "cli/verbs.h"
#include "store/store.h"

namespace umbrameter {

void add_plan(CLI::App& app, CommandLine& line);
void add_sweep(CLI::App& app, CommandLine& line);
void add_merge(CLI::App& app, CommandLine& line);
void add_export(CLI::App& app, CommandLine& line);

/// What the store found damaged since the last call.
void print_warnings(Store& store);

}  // namespace umbrameter
