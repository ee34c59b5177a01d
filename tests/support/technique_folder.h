// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique folder that a test writes for itself.

#include "tests/support/temporary_folder.h"

#include <string>
#include <string_view>

namespace umbrameter {

/// <temporary>/techniques/tried/, with an empty techniques/shared/ beside it.
class TechniqueFolder {
 public:
  TechniqueFolder();
  std::filesystem::path path() const { return root_.path() / "techniques" / "tried"; }
  std::filesystem::path techniques_folder() const { return root_.path() / "techniques"; }
  std::filesystem::path shared_folder() const { return techniques_folder() / "shared"; }
  /// The shader library of the source tree.
  static std::filesystem::path shaders_folder();

  /// Writes `text` to `name` in the technique's folder.
  TechniqueFolder& write(const std::string& name, std::string_view text);
  TechniqueFolder& write_shared(const std::string& name, std::string_view text);

 private:
  TemporaryFolder root_;
};

/// `text` with the one occurrence of `from` replaced; fails the test when there is not exactly one.
std::string replaced(std::string text, std::string_view from, std::string_view to);

/// The head of a manifest: everything before its parameters. Six lines.
std::string manifest_head();

}  // namespace umbrameter
