// SPDX-License-Identifier: Apache-2.0
#pragma once
// An adapter at work: started once, asked many times.

#include "engines/host/manifest.h"
#include "engines/host/process.h"
#include "engines/host/protocol.h"

#include <filesystem>
#include <memory>

namespace umbrameter {

class Adapter {
 public:
  /// Waits until it is ready. `work_folder` exists and is its working folder.
  Adapter(const Engine& engine, const std::filesystem::path& work_folder, Progress& progress);

  /// Throws like ForeignProcess and parse_answer().
  EngineAnswer ask(const EngineRequest& request, Progress& progress);
  const EngineReady& ready() const { return ready_; }

 private:
  EngineLimits limits_;
  ForeignProcess process_;
  EngineReady ready_;
};

/// How a program of an engine is started, whichever its form.
ProcessStart start_of(const Engine& engine, std::vector<std::string> arguments,
                      const std::filesystem::path& work_folder);

}  // namespace umbrameter
