#pragma once
// The verbs of sweeps and of the stores they fill.

#include "cli/verbs.h"

namespace umbrameter {

void add_plan(CLI::App& app, CommandLine& line);
void add_sweep(CLI::App& app, CommandLine& line);
void add_merge(CLI::App& app, CommandLine& line);
void add_export(CLI::App& app, CommandLine& line);

}  // namespace umbrameter
