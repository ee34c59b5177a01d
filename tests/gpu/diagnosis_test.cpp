// SPDX-License-Identifier: Apache-2.0
// Without these, faults and widths could be right on painted floors and wrong on what techniques draw.

#include "metrics/faults/faults.h"
#include "metrics/image/parity.h"
#include "metrics/penumbra/contact_hardening.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/case_scenes.h"
#include "tests/support/source_dir.h"
#include "tests/support/temporary_folder.h"

#include "core/files.h"
#include "core/progress.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace umbrameter {
namespace {

using namespace test;

Scene library(const std::string& name) {
  return load_scene(source_dir() / "scenes/library" / (name + ".toml"), SceneSearch{});
}

Scene scene_of(std::string_view text) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "scene.toml", text);
  return load_scene(folder.path() / "scene.toml", SceneSearch{});
}

struct Diagnosed {
  PenumbraError penumbra;
  ContactHardening hardening;
  Faults faults;
};

Image truth_of(const Scene& scene, int width_px, int height_px) {
  RenderRequest request;
  request.width_px = width_px;
  request.height_px = height_px;
  request.seed = 2;
  SilentProgress silent;
  return make_reference_renderer({256, {}, 0})->render(scene, request, silent).image;
}

Diagnosed diagnosed(const Scene& scene, const std::string& technique, const ParameterValues& parameters,
                    int width_px, int height_px) {
  const Image test = render(scene, technique, parameters, 1, width_px, height_px).image;
  const Image truth = truth_of(scene, width_px, height_px);
  const glm::dvec3& eye_world = scene.camera.eye_world;
  const std::vector<uint8_t> mask = scored_mask(compare_surfaces(test, truth, eye_world), truth);
  Diagnosed out;
  out.penumbra = measure_penumbra(test, truth, mask);
  out.hardening = measure_contact_hardening(out.penumbra);
  out.faults = classify_faults(test, truth, mask, out.penumbra.profiles,
                               measure_envelope(test, truth, mask, out.penumbra.profiles));
  return out;
}

double share(const Faults& faults, FaultClass fault) {
  return faults.of(fault).mean_abs_error;
}

FaultClass worst(const Faults& faults) {
  size_t worst = static_cast<size_t>(FaultClass::acne);
  for (size_t k = worst; k < kFaultClasses; ++k) {
    if (faults.by_class[k].mean_abs_error > faults.by_class[worst].mean_abs_error) worst = k;
  }
  return static_cast<FaultClass>(worst);
}

TEST(Diagnosis, AHardMapIsThreeOctavesTooNarrowAtEverySize) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = library("half_plane");
  for (const int height_px : {135, 270, 540}) {
    const Diagnosed hard = diagnosed(scene, "hard", {}, height_px * 16 / 9, height_px);
    ASSERT_TRUE(hard.penumbra.width_octaves) << height_px;
    EXPECT_EQ(hard.penumbra.width_octaves->median, -3.0) << height_px;
  }
}

TEST(Diagnosis, AnEvenNumberOfTapsMovesNoEdge) {
  UMBRAMETER_REQUIRE_GL();
  // Converged but for its levels; the penumbra is 1 wide.
  for (const int64_t taps : {8, 16, 17}) {
    const Diagnosed soft = diagnosed(
        library("half_plane"), "pcss",
        {{"map_size", int64_t{4096}}, {"search_taps", int64_t{256}}, {"filter_taps", taps}, {"noise", false}},
        480, 270);
    ASSERT_TRUE(soft.penumbra.offset_world) << taps;
    EXPECT_NEAR(soft.penumbra.offset_world->median, 0.0, 0.005) << taps;
  }
}

// Of the other six, three have penumbrae of one width, two no shadows, and wire's are too narrow at this size.
TEST(Diagnosis, HardeningIsIdentifiableWhereTrueWidthsDiffer) {
  UMBRAMETER_REQUIRE_GL();
  for (const char* name : {"box_contact", "colonnade", "comb", "contact_hardening", "fence", "plate",
                           "sphere_terminator", "stacked_plates"}) {
    EXPECT_TRUE(diagnosed(library(name), "pcss", {}, 320, 180).hardening.slope) << name;
    EXPECT_FALSE(diagnosed(library(name), "hard", {}, 320, 180).hardening.slope) << name;
  }
  for (const char* name : {"half_plane", "half_plane_disk", "disk_occluder"})
    EXPECT_FALSE(diagnosed(library(name), "pcss", {}, 320, 180).hardening.slope) << name;
}

TEST(Diagnosis, AFilterThatIsTooWideAtAContactIsNoAcneAndNoLeak) {
  UMBRAMETER_REQUIRE_GL();
  const Scene board = scene_of(kLeaningBoard);
  const Faults faults = diagnosed(board, "pcf_disk", {{"radius_texels", 32.0}}, 480, 270).faults;
  EXPECT_EQ(worst(faults), FaultClass::penumbra_too_wide);
  for (const FaultClass fault : {FaultClass::acne, FaultClass::geometric_leak, FaultClass::peter_panning})
    EXPECT_LT(share(faults, fault), 0.1 * *faults.mean_abs_error) << name_of(fault);
}

TEST(Diagnosis, ACasterThinnerThanATexelIsResolution) {
  UMBRAMETER_REQUIRE_GL();
  const Scene post = scene_of(R"(title = "Post at 8 km on a 20 km plane"
[camera]
eye = [8000, 3, 8]
at = [8000, 0.8, 0]
fov_deg = 45
[[mesh]]
shape = "plane"
size = [20000, 20000]
[[mesh]]
shape = "box"
size = [0.3, 2, 0.3]
translate = [8000, 0, 0]
[[mesh]]
shape = "box"
size = [2, 0.1, 2]
translate = [8000, 3.5, -1]
[[light]]
type = "sun"
direction = [0.5, -1, -0.3]
angular_diameter_deg = 2
)");
  const Faults faults = diagnosed(post, "hard", {{"map_fit", std::string("scene")}}, 480, 270).faults;
  EXPECT_EQ(worst(faults), FaultClass::resolution);
  EXPECT_LT(share(faults, FaultClass::peter_panning), 0.1 * *faults.mean_abs_error);
}

}  // namespace
}  // namespace umbrameter
