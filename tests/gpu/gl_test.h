// SPDX-License-Identifier: Apache-2.0
#pragma once
// A test with a context; skipped, with the reason, on a machine without GL.

#include "core/error.h"
#include "realtime/harness/context.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

namespace umbrameter::test {

inline std::filesystem::path shaders_folder() {
  return source_dir() / "realtime/shaders";
}

class GlTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      context_.emplace();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::environment) throw;
      GTEST_SKIP() << error.what();
    }
  }

  GlContext& context() { return *context_; }

 private:
  std::optional<GlContext> context_;
};

/// What the Error of `call` says; fails the test when it throws none or one of another kind.
template <class Call>
std::string error_of(ErrorKind kind, Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

}  // namespace umbrameter::test
