// SPDX-License-Identifier: Apache-2.0
// glTF files: any bytes are a scene or a sentence. An odd last byte means GLB.

#include "fuzz/fuzz_file.h"

#include "scenes/load_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  const bool is_binary = size > 0 && data[size - 1] % 2 == 1;
  const std::filesystem::path path = fuzz::write(is_binary ? "fuzz.glb" : "fuzz.gltf", {data, size});
  fuzz::expect_answer_or_sentence([&] { load_scene(path, {}); });
  return 0;
}
