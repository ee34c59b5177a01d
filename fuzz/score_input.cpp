// SPDX-License-Identifier: Apache-2.0
// Pictures of other engines: any bytes are visibility with a score, or a sentence.

#include "fuzz/fuzz_file.h"

#include "lab/pictures/picture_score.h"

namespace {

using namespace umbrameter;

/// A reference for whatever size came.
Image floor_of(int width, int height) {
  Image image(width, height);
  for (const char* zero :
       {"position.x", "position.y", "position.z", "normal.x", "normal.z", "shading_normal.x",
        "shading_normal.z", "primitive_id", "visibility_se", "blocker_distance_min", "blocker_layers"})
    image.add_plane(zero);
  for (const char* one :
       {"normal.y", "shading_normal.y", "unshadowed_irradiance", "visibility", "half_a", "half_b"})
    image.add_plane(one, 1.0f);
  image.add_plane("sample_count", 64.0f);
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    image.plane("position.x")[i] = static_cast<float>(i % static_cast<size_t>(width));
    image.plane("position.z")[i] = static_cast<float>(i / static_cast<size_t>(width));
  }
  return image;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::filesystem::path path = fuzz::write("fuzz.exr", {data, size});
  fuzz::expect_answer_or_sentence([&] {
    PictureFiles files;
    files.picture = path.string();
    const PictureInput input = read_picture_input(files);
    if (input.picture.light.size() > 4096) return;
    const Image reference = floor_of(input.picture.width, input.picture.height);
    score_picture(align_picture(input, {}, reference), reference, {0.0, 9.0, 0.0}, {}, {});
  });
  return 0;
}
