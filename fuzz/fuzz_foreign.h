// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scene files of other renderers, with a mesh and a picture beside them.

#include "fuzz/fuzz_file.h"

#include "core/image_io.h"
#include "scenes/load_scene.h"

namespace umbrameter::fuzz {

inline int read_foreign(const std::string& name, std::span<const uint8_t> bytes) {
  static const bool is_ready = [] {
    std::ofstream(folder() / "mesh.obj")
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    write_png(folder() / "mask.png", 1, 2, std::vector<uint8_t>{255, 255, 255, 0, 0, 0});
    return true;
  }();
  const std::filesystem::path path = write(name, bytes);
  expect_answer_or_sentence([&] {
    if (is_ready) load_scene(path, {});
  });
  return 0;
}

}  // namespace umbrameter::fuzz
