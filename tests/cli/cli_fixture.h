// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs the built umbrameter in a folder of the test's own, with no assets and no home from outside.

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

class CliTest : public testing::Test {
 protected:
  /// Arguments after the program's name; files are relative to folder().
  ProcessResult umbrameter(const std::vector<std::string>& arguments, ProcessOptions options = {}) const;
  const std::filesystem::path& folder() const { return folder_.path(); }
  /// Writes `text` to `name` in folder().
  void write(const std::string& name, std::string_view text) const;
  /// A small scene that loads, with `extra` appended.
  void write_scene(const std::string& name, const std::string& extra = {}) const;
  /// Names of everything in folder(), sorted.
  std::vector<std::string> files() const;
  /// Skips the test when this machine has no usable GL.
  void require_gl() const;

 private:
  TemporaryFolder folder_;
};

/// The built umbrameter.
std::string program_path();

/// Exit code 2, nothing on stdout, and exactly one line "umbrameter: error: ..." that holds `part`.
void expect_bad_input(const ProcessResult& result, const std::string& part);

/// The last line of `text`.
std::string last_line(const std::string& text);

}  // namespace umbrameter
