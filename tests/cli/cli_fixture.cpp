// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

namespace umbrameter {

std::string program_path() {
  return UMBRAMETER_BINARY;
}

ProcessResult CliTest::umbrameter(const std::vector<std::string>& arguments, ProcessOptions options) const {
  std::vector<std::string> command{program_path()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  options.working_folder = folder();
  options.environment.insert(options.environment.begin(),
                             {{"UMBRAMETER_ASSETS", ""}, {"UMBRAMETER_HOME", ""}});
  return run_process(command, options);
}

void CliTest::write(const std::string& name, std::string_view text) const {
  std::ofstream file(folder() / name, std::ios::binary);
  file << text;
  ASSERT_TRUE(file.good()) << name;
}

void CliTest::write_scene(const std::string& name, const std::string& extra) const {
  write(name, R"(title = "Plate"
[camera]
eye = [0, 2, 4]
at = [0, 0, 0]
[[light]]
type = "rect"
center = [0, 4, 0]
direction = [0, -1, 0]
size = [1, 1]
[[mesh]]
shape = "plane"
size = [8, 8]
[[mesh]]
shape = "plate"
size = [1, 1]
translate = [0, 1, 0]
)" + extra);
}

std::vector<std::string> CliTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

void CliTest::require_gl() const {
  const ProcessResult result = umbrameter({"doctor"});
  if (result.exit_code == 3) GTEST_SKIP() << "no usable GL: " << result.err;
}

void expect_bad_input(const ProcessResult& result, const std::string& part) {
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_THAT(result.err, testing::StartsWith("umbrameter: error: "));
  EXPECT_THAT(result.err, testing::HasSubstr(part));
}

std::string last_line(const std::string& text) {
  const size_t end = text.find_last_not_of('\n') + 1;
  const size_t start = text.rfind('\n', end - 1);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? 0 : start + 1));
}

}  // namespace umbrameter
