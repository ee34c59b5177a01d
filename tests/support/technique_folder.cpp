// SPDX-License-Identifier: Apache-2.0
#include "tests/support/technique_folder.h"

#include "core/files.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

namespace umbrameter {

TechniqueFolder::TechniqueFolder() {
  create_folder(path());
  create_folder(shared_folder());
}

std::filesystem::path TechniqueFolder::shaders_folder() {
  return source_dir() / "realtime" / "shaders";
}

TechniqueFolder& TechniqueFolder::write(const std::string& name, std::string_view text) {
  write_file_atomically(path() / name, text);
  return *this;
}

TechniqueFolder& TechniqueFolder::write_shared(const std::string& name, std::string_view text) {
  write_file_atomically(shared_folder() / name, text);
  return *this;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from << " stands there twice";
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string manifest_head() {
  return R"(schema = 1
id = "tried"
title = "Tried"
summary = "A technique of a test."
family = "hard"
lights = ["rect", "sun"]
)";
}

}  // namespace umbrameter
