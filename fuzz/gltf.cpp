// SPDX-License-Identifier: Apache-2.0
// glTF files: any bytes are a scene or a sentence. An odd last byte means GLB, and its next
// bit, where it is not set, a moment of all animations.

#include "fuzz/fuzz_file.h"

#include "scenes/load_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  const bool is_binary = size > 0 && data[size - 1] % 2 == 1;
  const std::filesystem::path path = fuzz::write(is_binary ? "fuzz.glb" : "fuzz.gltf", {data, size});
  SceneSearch search;
  if (size > 0 && data[size - 1] / 2 % 2 == 0) search.at = AnimationTime{0.5, "all"};
  fuzz::expect_answer_or_sentence([&] { load_scene(path, search); });
  return 0;
}
