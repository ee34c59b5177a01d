// SPDX-License-Identifier: Apache-2.0
// OBJ files: any bytes are a mesh or a sentence. An odd last byte means zstd-compressed.

#include "fuzz/fuzz_file.h"

#include "scenes/obj/load_obj.h"

#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  const bool is_compressed = size > 0 && data[size - 1] % 2 == 1;
  const std::filesystem::path path = fuzz::write(is_compressed ? "fuzz.obj.zst" : "fuzz.obj", {data, size});
  fuzz::expect_answer_or_sentence([&] {
    std::vector<std::string> warnings;
    load_obj(path, {}, warnings);
  });
  return 0;
}
