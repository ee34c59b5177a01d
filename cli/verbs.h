// SPDX-License-Identifier: Apache-2.0
#pragma once
// The composition root: every verb registers itself and leaves a function to run.

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace umbrameter {

struct GlobalOptions {
  std::string assets;  // --assets or UMBRAMETER_ASSETS; empty = none
  std::string device;
  std::string out;
  std::string
      light;  // of verbs that have --light (cli/scene_options.h): name or number; empty = none is chosen
  std::optional<double> time_s;  // of verbs that have --time
  std::string animation;         // likewise; as AnimationTime's
  int threads = 0;
  bool json = false;
};

/// What the command line asked for; `verb` returns the exit code.
struct CommandLine {
  GlobalOptions global;
  std::function<int()> verb;
};

inline constexpr int kExitFine = 0;
inline constexpr int kExitGateFailed = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitEnvironment = 3;
inline constexpr int kExitInternal = 4;
inline constexpr int kExitInterrupted = 130;

void add_validate(CLI::App& app, CommandLine& line);
void add_bench(CLI::App& app, CommandLine& line);
void add_tune(CLI::App& app, CommandLine& line);
void add_reference(CLI::App& app, CommandLine& line);
void add_render(CLI::App& app, CommandLine& line);
void add_score(CLI::App& app, CommandLine& line);
void add_report(CLI::App& app, CommandLine& line);
void add_techniques(CLI::App& app, CommandLine& line);
void add_scene(CLI::App& app, CommandLine& line);
void add_selftest(CLI::App& app, CommandLine& line);
void add_regress(CLI::App& app, CommandLine& line);
void add_stress(CLI::App& app, CommandLine& line);
void add_engines(CLI::App& app, CommandLine& line);
void add_metrics(CLI::App& app, CommandLine& line);
void add_doctor(CLI::App& app, CommandLine& line);
void add_help(CLI::App& app, CommandLine& line);

}  // namespace umbrameter
