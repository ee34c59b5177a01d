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
  // 12,000 x 12,000 px need some 13 GB.
  const ProcessResult result =
      run_process({"bash", "-c", "ulimit -v 4000000; exec \"$0\" \"$@\"", UMBRAMETER_BINARY, "reference",
                   "plate", "--width", "12000", "--height", "12000", "-o", "ref.exr"},
                  {.working_folder = folder()});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("not enough memory"));
  EXPECT_THAT(files(), IsEmpty());
}

}  // namespace
}  // namespace umbrameter
