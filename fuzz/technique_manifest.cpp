// SPDX-License-Identifier: Apache-2.0
// Technique manifests: any text is a technique or a sentence.

#include "fuzz/fuzz_file.h"

#include "realtime/manifest/technique.h"

namespace {

constexpr char kShader[] = "void main() {}\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  static const std::filesystem::path techniques =
      std::filesystem::path(UMBRAMETER_SOURCE_DIR) / "realtime/techniques";
  for (const char* file : {"hard.frag", "blur.comp"})
    fuzz::write(file, {reinterpret_cast<const uint8_t*>(kShader), sizeof kShader - 1});
  fuzz::write("technique.toml", {data, size});
  fuzz::expect_answer_or_sentence([] { load_technique(fuzz::folder(), techniques / "shared"); });
  return 0;
}
