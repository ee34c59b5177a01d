// SPDX-License-Identifier: Apache-2.0
// Without this a picture too big for the machine could end in a crash or a message that helps nobody.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class MemoryFull : public CliTest {};

TEST_F(MemoryFull, IsAClearErrorAndLeavesNothing) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer needs more address space than the limit leaves";
#endif
  // 7680 x 4320 px need some 3 GB.
  const ProcessResult result =
      run_process({"bash", "-c", "ulimit -v 2000000; exec \"$0\" \"$@\"", program_path(), "reference",
                   "plate", "--width", "7680", "--height", "4320", "-o", "ref.exr"},
                  {.working_folder = folder()});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("not enough memory"));
  EXPECT_THAT(files(), IsEmpty());
}

}  // namespace
}  // namespace umbrameter
