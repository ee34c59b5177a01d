// SPDX-License-Identifier: Apache-2.0
// Without these: a change of pictures that no closed form covers (sampling order, filter weights, bias) could
// pass unseen. Update on purpose with UMBRAMETER_UPDATE_GOLDEN=1 and say in the commit why the pictures
// changed.
#include "core/error.h"
#include "core/image_io.h"
#include "realtime/manifest/technique.h"
#include "realtime/realtime.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = source_dir();
const RenderRequest kSmall = {.width_px = 96, .height_px = 54, .seed = 1, .technique = {}, .parameters = {}};

/// How far a picture may be from its golden one: values apart by more than `step` in at most `share` of the
/// pixels.
struct Tolerance {
  double step;
  double share;
};
/// Embree's kernels differ by instruction set: a ray that grazes an edge may fall on either side, which moves
/// a pixel of 64 samples by a 64th.
constexpr Tolerance kReference = {1.5 / 64, 0.002};
/// Rasterisers may place an edge on either side of a texel's centre; llvmpipe's own versions differ by
/// rounding.
constexpr Tolerance kRealtime = {0.02, 0.005};

Image visibility_of(const Frame& frame) {
  Image image(frame.image.width, frame.image.height);
  const std::span<const float> from = frame.image.plane("visibility");
  std::ranges::copy(from, image.add_plane("visibility").begin());
  return image;
}

double share_apart(const Image& image, const Image& golden, double step) {
  const std::span<const float> a = image.plane("visibility");
  const std::span<const float> b = golden.plane("visibility");
  size_t apart = 0;
  for (size_t i = 0; i < a.size(); ++i) apart += std::abs(a[i] - b[i]) > step ? 1 : 0;
  return static_cast<double>(apart) / static_cast<double>(a.size());
}

bool is_update_asked_for() {
  const char* value = std::getenv("UMBRAMETER_UPDATE_GOLDEN");
  return value != nullptr && std::string_view(value) == "1";
}

/// Leaves the picture beside the test binary when it differs, for looking at both.
void expect_golden(const Image& image, const std::string& name, const Tolerance& tolerance) {
  const fs::path file = kRoot / "tests/golden/images" / (name + ".exr");
  if (is_update_asked_for()) write_exr(file, image);
  const Image golden = read_image(file);
  require_same_size(image, golden, name);
  const double share = share_apart(image, golden, tolerance.step);
  if (share > tolerance.share) write_exr(name + "-now.exr", image);
  EXPECT_LE(share, tolerance.share) << name << ": share of pixels apart by more than " << tolerance.step
                                    << "; see " << name << "-now.exr";
}

Scene library_scene(const std::string& name) {
  return load_scene(kRoot / "scenes/library" / (name + ".toml"), {{}, kRoot / "scenes/library"});
}

Image reference_picture(const std::string& scene) {
  SilentProgress progress;
  return visibility_of(make_reference_renderer({.samples_per_pixel = 64, .target_se = {}})
                           ->render(library_scene(scene), kSmall, progress));
}

class GoldenTechnique : public testing::TestWithParam<std::string> {};

TEST_P(GoldenTechnique, LooksAsBefore) {
  std::unique_ptr<Renderer> renderer;
  try {
    renderer = make_realtime_renderer({.techniques_folder = kRoot / "realtime/techniques",
                                       .shaders_folder = kRoot / "realtime/shaders",
                                       .device = {}});
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  RenderRequest request = kSmall;
  request.technique = GetParam();
  const Technique technique = find_technique(GetParam(), kRoot / "realtime/techniques");
  if (std::ranges::find(technique.parameters, "map_size", &Parameter::name) != technique.parameters.end())
    request.parameters["map_size"] = int64_t{512};
  SilentProgress progress;
  const Frame frame = renderer->render(library_scene("contact_hardening"), request, progress);
  if (frame.device.find("llvmpipe") == std::string::npos)
    GTEST_SKIP() << "goldens are llvmpipe's, not " << frame.device;
  expect_golden(visibility_of(frame), "contact_hardening-" + GetParam(), kRealtime);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, GoldenTechnique,
                         testing::Values("hard", "pcf", "pcss", "accumulate", "pcf_temporal", "pcss_temporal",
                                         "msm6", "ray_traced", "ray_traced_svgf"),
                         [](const auto& instance) { return instance.param; });

TEST(GoldenReference, ContactHardeningLooksAsBefore) {
  expect_golden(reference_picture("contact_hardening"), "contact_hardening-reference", kReference);
}

TEST(GoldenReference, CombLooksAsBefore) {
  expect_golden(reference_picture("comb"), "comb-reference", kReference);
}

TEST(GoldenReference, AnotherPictureIsRejected) {
  const Image golden = read_image(kRoot / "tests/golden/images/comb-reference.exr");
  EXPECT_GT(share_apart(reference_picture("contact_hardening"), golden, kReference.step), kReference.share);
}

}  // namespace
}  // namespace umbrameter
