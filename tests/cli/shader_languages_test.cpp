// SPDX-License-Identifier: Apache-2.0
// Without this the shaders that people take into their engines might compile nowhere.

#include "tests/cli/cli_fixture.h"

#include "core/files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class ShaderLanguages : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  /// The files of one technique in one language.
  std::vector<std::filesystem::path> write_shaders(const std::string& technique,
                                                   const std::string& language) const {
    const ProcessResult result =
        umbrameter({"techniques", "glsl", technique, "--language", language, "--json", "-o", language});
    EXPECT_EQ(result.exit_code, 0) << technique << ", " << language << ": " << result.err;
    EXPECT_EQ(result.err.find("ignored"), std::string::npos) << result.err;
    std::vector<std::filesystem::path> files;
    if (result.exit_code != 0) return files;
    const Json answer = Json::parse(result.out);
    for (const Json& shader : answer["shaders"])
      files.push_back(folder() / shader["file"].get<std::string>());
    EXPECT_FALSE(files.empty()) << technique;
    return files;
  }
  void expect_accepted(std::vector<std::string> compiler, const std::filesystem::path& file) const {
    compiler.push_back(file.string());
    const ProcessResult result = run_process(compiler);
    EXPECT_EQ(result.exit_code, 0) << file << ": " << result.out << result.err;
  }
};

std::string stage_of(const std::filesystem::path& file) {
  return file.stem().extension().string().substr(1);  // of "0-map.vert.hlsl"
}

TEST_F(ShaderLanguages, EveryTechniqueCompilesAsHlsl) {
  size_t compiled = 0;
  const Json list = Json::parse(umbrameter({"techniques", "--json"}).out);
  for (const Json& technique : list["techniques"]) {
    for (const auto& file : write_shaders(technique["id"], "hlsl")) {
      expect_accepted({"glslangValidator", "-D", "-V", "-e", "main", "-S", stage_of(file), "-o",
                       (folder() / "hlsl.spv").string()},
                      file);
      ++compiled;
    }
  }
  EXPECT_GT(compiled, 20u);
}

TEST_F(ShaderLanguages, PcssCompilesAsSpirvAndGlslEsAndIsWrittenForMetal) {
  for (const auto& file : write_shaders("pcss", "spirv")) expect_accepted({"spirv-val"}, file);
  for (const auto& file : write_shaders("pcss", "essl"))
    expect_accepted({"glslangValidator", "-S", stage_of(file)}, file);
  for (const auto& file : write_shaders("pcss", "msl"))  // no compiler of it is free
    EXPECT_NE(read_file(file).find("#include <metal_stdlib>"), std::string::npos) << file;
}

TEST_F(ShaderLanguages, TextIsThatOfAPresetFile) {
  write("five.toml", R"(technique = "pcss"
[[preset]]
name = "five"
doc = "five taps"
[preset.values]
filter_taps = 5
)");
  const ProcessResult result = umbrameter({"techniques", "glsl", "pcss:preset=five.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("#define FILTER_TAPS 5\n"), std::string::npos);
}

TEST_F(ShaderLanguages, WrongOnesAreRefused) {
  expect_bad_input(umbrameter({"techniques", "glsl", "pcf", "--language", "hsls"}), "did you mean 'hlsl'?");
  expect_bad_input(umbrameter({"techniques", "glsl", "pcf", "--language", "spirv"}), "give --out DIR");
}

}  // namespace
}  // namespace umbrameter
