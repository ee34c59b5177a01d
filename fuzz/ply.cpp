// SPDX-License-Identifier: Apache-2.0
// The look at a PLY file before assimp gets it, without assimp, which is not safe.

#include "fuzz/fuzz_file.h"

#include "scenes/assimp/check_ply.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  const std::filesystem::path path = fuzz::write("fuzz.ply", {data, size});
  fuzz::expect_answer_or_sentence([&] { check_ply(path); });
  return 0;
}
