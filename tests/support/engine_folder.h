// SPDX-License-Identifier: Apache-2.0
#pragma once
// Engine folders that tests write for themselves.

#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace umbrameter {

/// <temporary>/engines/tried/ with a manifest of tests/engine/adapter.py.
class EngineFolder {
 public:
  EngineFolder();
  std::filesystem::path path() const { return engines() / "tried"; }
  std::filesystem::path engines() const { return root_.path() / "engines"; }
  std::filesystem::path work() const { return root_.path() / "work"; }

  /// Writes `text` to `name` in the engine's folder.
  EngineFolder& write(const std::string& name, std::string_view text);

 private:
  TemporaryFolder root_;
};

/// The manifest of tests/engine/adapter.py, with short limits.
std::string test_engine_manifest();
/// A manifest without a form: append adapter, command or pictures, before any table.
std::string engine_manifest_with(const std::string& form);

}  // namespace umbrameter
