// SPDX-License-Identifier: Apache-2.0
// A number buried in a shader is a parameter nobody can sweep: each needs its reason on the same or the line
// before.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/source_dir.h"

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

/// "line: literal" of each number in `text` that is not plain and not explained.
std::vector<std::string> unexplained_literals(std::istream& text) {
  static const std::regex number(R"((^|[^\w.])((\d+\.?\d*|\.\d+)([eE][-+]?\d+)?u?f?))");
  static const std::set<std::string> plain = {"0", "0u", "0.0", "0.5", "1", "1u", "1.0", "2", "2u", "2.0"};
  std::vector<std::string> found;
  bool was_explained = false;
  int line_number = 0;
  for (std::string line; std::getline(text, line);) {
    ++line_number;
    const bool is_explained = line.find("// const: ") != std::string::npos;
    const std::string code = line.substr(0, line.find("//"));
    for (std::sregex_iterator match(code.begin(), code.end(), number), end; match != end; ++match) {
      const std::string literal = (*match)[2];
      if (plain.contains(literal) || is_explained || was_explained) continue;
      found.push_back(std::to_string(line_number) + ": " + literal);
    }
    was_explained = is_explained && code.find_first_not_of(" \t") == std::string::npos;
  }
  return found;
}

/// A table that a script wrote explains its numbers in the line after its licence.
bool is_generated(std::istream& text) {
  std::string licence, about;
  std::getline(text, licence);
  std::getline(text, about);
  text.seekg(0);
  return about.find("Written by scripts/") != std::string::npos;
}

TEST(shader_literals, of_techniques_and_library_are_plain_or_explained) {
  const fs::path realtime = source_dir() / "realtime";
  const std::set<std::string> endings = {".frag", ".vert", ".comp", ".glsl"};
  size_t files = 0;
  for (const fs::path& folder : {realtime / "techniques", realtime / "shaders/lib"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (!endings.contains(entry.path().extension().string())) continue;
      if (entry.path().extension() == ".vert" && folder.filename() == "lib") continue;  // clip-space corners
      std::ifstream text(entry.path());
      if (is_generated(text)) continue;
      EXPECT_EQ(unexplained_literals(text), std::vector<std::string>{}) << entry.path();
      ++files;
    }
  }
  EXPECT_GE(files, 10u);
}

TEST(shader_literals, are_found_where_they_hide) {
  std::istringstream text(
      "float a = 0.5 * x2 + 3.25;\n// const: because\nfloat b = 7.0;\nint c = 9;  // const: why\nd = 1e-3;");
  EXPECT_EQ(unexplained_literals(text), (std::vector<std::string>{"1: 3.25", "5: 1e-3"}));
}

}  // namespace
}  // namespace umbrameter
