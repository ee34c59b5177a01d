// SPDX-License-Identifier: Apache-2.0
// Scene files: any text is a scene or a sentence.

#include "fuzz/fuzz_file.h"

#include "scenes/load_scene.h"

#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  fuzz::expect_answer_or_sentence([&] { parse_scene(text, fuzz::folder() / "fuzz.toml", {}); });
  return 0;
}
