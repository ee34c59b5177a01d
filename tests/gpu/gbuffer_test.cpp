// SPDX-License-Identifier: Apache-2.0
// Without these, shadows would be computed for other points than the ones the truth is computed for.

#include "realtime/harness/gbuffer.h"
#include "metrics/image/parity.h"
#include "reference/reference.h"
#include "tests/gpu/gl_test.h"
#include "tests/support/procedural_scene.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <random>

namespace umbrameter {
namespace {

class GBufferTest : public test::GlTest {
 protected:
  Image draw(const Scene& scene, int width_px, int height_px) {
    ProgramCache programs({test::shaders_folder() / "lib", test::shaders_folder() / "shared"});
    GBufferRenderer renderer(programs, test::shaders_folder(), context().limits());
    const SceneBuffers buffers(scene);
    const GBuffer gbuffer(width_px, height_px);
    renderer.render(scene, buffers, gbuffer);
    Image image(width_px, height_px);
    read_gbuffer(gbuffer, image);
    return image;
  }
};

glm::dvec3 vector_at(const Image& image, const std::string& name, size_t i) {
  return {image.plane(name + ".x")[i], image.plane(name + ".y")[i], image.plane(name + ".z")[i]};
}

Scene floor_from_above() {
  Scene scene;
  add_floor(scene, {2.0, 2.0});
  scene.camera = camera_above({0, 0, 0}, 4.0, 4.0);
  scene.lights = {rect_light_above({0, 3, 0}, {1, 1})};
  finish_scene(scene);
  return scene;
}

TEST_F(GBufferTest, AFloorSeenFromAboveLiesWherePixelCentresSay) {
  // 4 world units over 16 px: the 2 x 2 floor covers pixels 4..11; up is -z, so row 0 is the far, negative-z
  // side.
  const Image image = draw(floor_from_above(), 16, 16);
  for (size_t y = 0; y < 16; ++y) {
    for (size_t x = 0; x < 16; ++x) {
      const size_t i = y * 16 + x;
      const bool is_covered = x >= 4 && x < 12 && y >= 4 && y < 12;
      ASSERT_EQ(image.plane("primitive_id")[i] >= 0.0f, is_covered) << x << ", " << y;
      if (!is_covered) continue;
      const glm::dvec3 expected((static_cast<double>(x) + 0.5) / 4 - 2, 0.0,
                                (static_cast<double>(y) + 0.5) / 4 - 2);
      ASSERT_LT(glm::distance(vector_at(image, "position", i), expected), 1e-6) << x << ", " << y;
      ASSERT_EQ(vector_at(image, "normal", i), glm::dvec3(0, 1, 0));
      // add_floor's triangles a b c and a c d meet on the diagonal from (-1, +1) to (+1, -1); c d a is the
      // -z, -x one.
      if (x + y != 15) {
        ASSERT_EQ(image.plane("primitive_id")[i], x + y > 15 ? 0.0f : 1.0f) << x << ", " << y;
      }
    }
  }
}

TEST_F(GBufferTest, BackFacesAreSeenWithTheirNormalTurnedToTheCamera) {
  Scene scene = floor_from_above();
  for (glm::uvec3& triangle : scene.triangles.edit()) std::swap(triangle.x, triangle.y);
  const Image image = draw(scene, 8, 8);
  EXPECT_EQ(vector_at(image, "normal", 3 * 8 + 3), glm::dvec3(0, 1, 0));
}

TEST_F(GBufferTest, AFloorThatPassesUnderTheCameraHasNoHolesAndExactPositions) {
  Scene scene;
  add_floor(scene, {2000.0, 2000.0});
  scene.camera.eye_world = {0.3, 1.7, 0.2};
  scene.camera.at_world = {10.0, 0.0, 4.0};
  scene.lights = {sun_light({0, 1, 0}, 0.01)};
  finish_scene(scene);
  constexpr int kWidth = 96, kHeight = 64;
  const Image image = draw(scene, kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec3 d = camera_ray_direction_world(scene.camera, {x + 0.5, y + 0.5}, kWidth, kHeight);
      const double distance = -scene.camera.eye_world.y / d.y;
      const glm::dvec3 expected = scene.camera.eye_world + distance * d;
      const auto i = static_cast<size_t>(y * kWidth + x);
      const bool is_floor = d.y < 0.0 && std::max(std::abs(expected.x), std::abs(expected.z)) < 1000.0;
      ASSERT_EQ(image.plane("primitive_id")[i] >= 0.0f, is_floor) << x << ", " << y;
      if (!is_floor) continue;
      // A float direction is off by 2^-24; on a floor seen at a slope of sin = -d.y that is distance / sin.
      ASSERT_LT(glm::distance(vector_at(image, "position", i), expected), 4 * 0x1p-24 * distance / -d.y);
    }
  }
}

/// Triangles about half a pixel wide, all over the picture and at all depths.
Scene dust(size_t count) {
  Scene scene;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&] { return glm::dvec3(unit(generator), unit(generator), unit(generator)); };
  for (size_t i = 0; i < count; ++i) {
    const glm::dvec3 middle = point();
    const auto first = static_cast<uint32_t>(scene.positions_world.size());
    for (int corner = 0; corner < 3; ++corner)
      scene.positions_world.edit().emplace_back(middle + 0.03 * point());
    scene.triangles.edit().emplace_back(first, first + 1, first + 2);
  }
  scene.camera.eye_world = {0.2, 0.1, 5.0};
  scene.camera.at_world = {0, 0, 0};
  scene.lights = {sphere_light({2, 6, 3}, 0.5)};
  finish_scene(scene);
  return scene;
}

void expect_parity(const Scene& scene, const Image& image, double required_same_primitive) {
  // Enough samples for the reference's own irradiance to be good to well under parity's 2 %.
  const auto reference = make_reference_renderer({.samples_per_pixel = 1024, .target_se = {}});
  SilentProgress progress;
  RenderRequest request;
  request.width_px = image.width;
  request.height_px = image.height;
  const Frame frame = reference->render(scene, request, progress);
  const glm::dvec3& eye_world = scene.camera.eye_world;
  const Parity parity = compare_surfaces(image, frame.image, eye_world);
  EXPECT_GT(parity.covered, 1000u);
  EXPECT_TRUE(parity.passes) << parity.coverage_mismatch << " coverage, " << parity.surface_mismatch
                             << " surface, " << parity.irradiance_mismatch << " irradiance of "
                             << parity.covered;
  EXPECT_GE(static_cast<double>(parity.same_primitive),
            required_same_primitive * static_cast<double>(parity.covered));
}

// The rasteriser alone snaps vertices to 1/256 px and so shows another triangle in about a hundredth of such
// pixels.
TEST_F(GBufferTest, SubpixelTrianglesAreTheOnesARayTracerFinds) {
  const Scene scene = dust(20000);
  expect_parity(scene, draw(scene, 96, 96), 0.9995);
}

TEST_F(GBufferTest, ClosedMeshesAgreeWithTheReference) {
  Scene scene;
  add_floor(scene, {8.0, 8.0});
  add_sphere(scene, {0, 1, 0}, 1.0, 24);
  add_box(scene, {1.5, 0.0, -1.0}, {2.0, 2.0, 1.0});
  scene.camera.eye_world = {1.0, 2.5, 6.0};
  scene.camera.at_world = {0, 0.8, 0};
  scene.lights = {rect_light_above({1, 4, 1}, {2, 1})};
  finish_scene(scene);
  // Pixels on a shared edge may show either neighbour.
  expect_parity(scene, draw(scene, 96, 64), 0.998);
}

TEST_F(GBufferTest, ShadingNormalsAreInterpolatedAndStayOnTheGeometricSide) {
  Scene scene = floor_from_above();
  // Normals that lean away from the middle, turned upside down: they must come back on the camera's side.
  for (const glm::vec3& p : scene.positions_world) {
    scene.normals_world.edit().push_back(-glm::normalize(glm::vec3(p.x, 2.0f, p.z)));
  }
  const Image image = draw(scene, 16, 16);
  const size_t i = 5 * 16 + 9;
  const glm::dvec3 p = vector_at(image, "position", i);
  // The corners' normals are linear in x and z up to one common length.
  const glm::dvec3 expected = glm::normalize(glm::dvec3(p.x, 2.0, p.z));
  EXPECT_LT(glm::distance(vector_at(image, "shading_normal", i), expected), 1e-6);
  EXPECT_EQ(vector_at(image, "normal", i), glm::dvec3(0, 1, 0));
}

/// Mean irradiance weight over a fine grid of the light.
double irradiance_by_counting(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world) {
  constexpr int kSteps = 400;
  double sum = 0.0;
  for (int v = 0; v < kSteps; ++v) {
    for (int u = 0; u < kSteps; ++u) {
      sum +=
          sample_light(light, p_world, n_world, {(u + 0.5) / kSteps, (v + 0.5) / kSteps}).irradiance_weight;
    }
  }
  return sum / (kSteps * kSteps);
}

class IrradianceTest : public GBufferTest, public ::testing::WithParamInterface<Light> {};

TEST_P(IrradianceTest, AgreesWithTheLightsDefinitionEvenWhereTheHorizonCutsTheLight) {
  Scene scene;
  add_sphere(scene, {0, 0, 0}, 1.0, 12);  // facets at every angle to the light
  scene.camera.eye_world = {3.0, 2.0, 3.0};
  scene.camera.at_world = {0, 0, 0};
  scene.lights = {GetParam()};
  finish_scene(scene);
  const Image image = draw(scene, 16, 16);
  double largest = 0.0;
  for (const float e : image.plane("unshadowed_irradiance"))
    largest = std::max(largest, static_cast<double>(e));
  ASSERT_GT(largest, 0.0);
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const double actual = image.plane("unshadowed_irradiance")[i];
    if (image.plane("primitive_id")[i] < 0.0f) {
      ASSERT_EQ(actual, 0.0);
      continue;
    }
    const double expected = irradiance_by_counting(GetParam(), vector_at(image, "position", i),
                                                   vector_at(image, "shading_normal", i));
    // The grid itself resolves a light cut by the horizon to 1/400 of its width.
    ASSERT_NEAR(actual, expected, 0.005 * expected + 1e-5 * largest) << "pixel " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, IrradianceTest,
                         ::testing::Values(rect_light_above({0.5, 2.5, 0.3}, {3.0, 1.0}),
                                           disk_light_above({0.5, 2.5, 0.3}, 1.5),
                                           sphere_light({1, 3, 1}, 1.2), sun_light({1, 1, 0.5}, 0.3)),
                         [](const auto& test) { return std::string(to_text(test.param.type)); });

TEST_F(GBufferTest, ASmallLightOverheadObeysTheInverseSquareLaw) {
  Scene scene = floor_from_above();
  scene.lights = {rect_light_above({0, 2, 0}, {0.01, 0.01})};
  const Image image = draw(scene, 17, 17);
  // Straight below: area / height^2, both cosines 1.
  EXPECT_NEAR(image.plane("unshadowed_irradiance")[8 * 17 + 8], 1e-4 / 4.0, 1e-9);
}

}  // namespace
}  // namespace umbrameter
