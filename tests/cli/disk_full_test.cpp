// SPDX-License-Identifier: Apache-2.0
// Without this a full disk could leave half an image behind, lose what was stored, or end in a message that helps nobody.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;

class DiskFull : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  /// 'validate' where no file may grow beyond `limit_KiB`: the write fails as on a full disk.
  ProcessResult validate_within(int limit_KiB, const std::vector<std::string>& arguments) {
    std::vector<std::string> all{
        "bash", "-c", "trap '' XFSZ; ulimit -f " + std::to_string(limit_KiB) + "; exec \"$0\" \"$@\"",
        program_path(), "validate"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_process(all, {.working_folder = folder()});
  }
};

TEST_F(DiskFull, IsAClearErrorAndLosesNothing) {
  const std::vector<std::string> small{"validate", "plate",    "--technique", "hard",  "--width",
                                       "32",       "--height", "18",          "--spp", "8",
                                       "--frames", "0",        "--json"};
  const ProcessResult first = umbrameter(small);
  ASSERT_EQ(first.exit_code, 0) << first.err;

  // The store and the small images fit; one picture of 640 x 360 px with its surfaces does not.
  const ProcessResult full = validate_within(1024, {"plate", "--technique", "hard", "--width", "640",
                                                    "--height", "360", "--spp", "1", "--frames", "0"});
  EXPECT_THAT(full.exit_code, AnyOf(2, 3)) << full.err;
  EXPECT_THAT(full.err, HasSubstr("cannot be written"));
  EXPECT_THAT(full.err, HasSubstr("is there room"));

  const ProcessResult again = umbrameter(small);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const Json results = Json::parse(again.out);
  EXPECT_EQ(results["work"]["rendered"], 0);
  EXPECT_EQ(results["work"]["references_rendered"], 0);
  EXPECT_EQ(results["scenes"], Json::parse(first.out)["scenes"]);
}

}  // namespace
}  // namespace umbrameter
