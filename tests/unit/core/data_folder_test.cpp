// SPDX-License-Identifier: Apache-2.0
// Without these a program that was copied or installed could read the folder it was built in, or fail without saying why.

#include "core/data_folder.h"

#include "core/error.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace umbrameter {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class DataFolder : public testing::Test {
 protected:
  void SetUp() override { unsetenv("UMBRAMETER_HOME"); }
  void TearDown() override { unsetenv("UMBRAMETER_HOME"); }

  fs::path root() const { return fs::canonical(folder_.path()); }
  /// A complete data folder.
  fs::path make(const std::string& name) const {
    for (const char* part : {"scenes/library", "realtime/techniques", "realtime/shaders"}) {
      fs::create_directories(root() / name / part);
      std::ofstream(root() / name / part / "a") << "a";
    }
    return root() / name;
  }

 private:
  TemporaryFolder folder_;
};

std::string problem(const fs::path& program) {
  try {
    return "found " + find_data_folder(program).string();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::environment);
    return error.what();
  }
}

TEST_F(DataFolder, LiesInShareOfTheProgramsPrefix) {
  const fs::path data = make("usr/share/umbrameter");
  EXPECT_EQ(find_data_folder(root() / "usr/bin/umbrameter"), data);
}

TEST_F(DataFolder, ALinkIsResolvedSoThatMessagesNameTheSources) {
  const fs::path data = make("sources");
  fs::create_directories(root() / "build/share");
  fs::create_directory_symlink(data, root() / "build/share/umbrameter");
  EXPECT_EQ(find_data_folder(root() / "build/cli/umbrameter"), data);
}

TEST_F(DataFolder, ACopiedProgramFindsNothingAndSaysWhereItLooked) {
  make("usr/share/umbrameter");
  const std::string text = problem(root() / "elsewhere/deep/umbrameter");
  EXPECT_THAT(text, HasSubstr((root() / "elsewhere/share/umbrameter").string() + "' is not there"));
  EXPECT_THAT(text, HasSubstr("UMBRAMETER_HOME"));
}

TEST_F(DataFolder, MoreLevelsLookFurtherUp) {
  const fs::path data = make("usr/share/umbrameter");
  EXPECT_EQ(find_data_folder(root() / "usr/lib/python3/umbrameter/module.so", 3), data);
  EXPECT_THAT(problem(root() / "usr/lib/python3/umbrameter/module.so"), HasSubstr("is not there"));
}

TEST_F(DataFolder, TheEnvironmentGoesFirstAndIsHeldToTheSame) {
  make("usr/share/umbrameter");
  const fs::path chosen = make("mine");
  setenv("UMBRAMETER_HOME", chosen.c_str(), 1);
  EXPECT_EQ(find_data_folder(root() / "usr/bin/umbrameter"), chosen);
  fs::remove_all(chosen / "realtime/shaders");
  EXPECT_THAT(
      problem(root() / "usr/bin/umbrameter"),
      HasSubstr("UMBRAMETER_HOME '" + chosen.string() + "' has no realtime/shaders, or an empty one"));
}

TEST_F(DataFolder, AnEmptyPartIsMissed) {
  const fs::path data = make("usr/share/umbrameter");
  fs::remove(data / "scenes/library/a");
  EXPECT_THAT(problem(root() / "usr/bin/umbrameter"),
              HasSubstr("the data folder '" + data.string() + "' has no scenes/library, or an empty one"));
}

}  // namespace
}  // namespace umbrameter
