// SPDX-License-Identifier: Apache-2.0
#include "tests/support/lab/fakes.h"

#include "core/error.h"

namespace umbrameter {

Image floor_image() {
  Image image(kFakeWidth_px, kFakeHeight_px);
  auto x_world = image.add_plane("position.x");
  image.add_plane("position.y");
  auto z_world = image.add_plane("position.z");
  image.add_plane("normal.x");
  image.add_plane("normal.y", 1.0f);
  image.add_plane("normal.z");
  auto primitive = image.add_plane("primitive_id");
  auto irradiance = image.add_plane("unshadowed_irradiance", 1.0f);
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const size_t column = i % kFakeWidth_px;
    x_world[i] = static_cast<float>(column);
    z_world[i] = static_cast<float>(i / kFakeWidth_px);
    if (column > 0) continue;
    primitive[i] = -1.0f;
    irradiance[i] = 0.0f;
  }
  return image;
}

Image reference_image() {
  Image image = floor_image();
  for (const char* channel :
       {"visibility", "half_a", "half_b", "irradiance_ratio", "irradiance_half_a", "irradiance_half_b"})
    image.add_plane(channel, 0.5f);
  image.add_plane("visibility_se");
  image.add_plane("irradiance_ratio_se");
  image.add_plane("sample_count", 64.0f);
  image.add_plane("shading_normal.x");
  image.add_plane("shading_normal.y", 1.0f);
  image.add_plane("shading_normal.z");
  image.add_plane("blocker_distance_min", 100.0f);  // far from contact
  image.add_plane("blocker_layers", 1.0f);
  return image;
}

Image shadowed_reference_image() {
  Image image = reference_image();
  for (const char* channel :
       {"visibility", "half_a", "half_b", "irradiance_ratio", "irradiance_half_a", "irradiance_half_b"}) {
    auto plane = image.plane(channel);
    for (size_t i = 0; i < plane.size(); ++i) plane[i] = i % kFakeWidth_px < 25 ? 0.0f : 1.0f;
  }
  return image;
}

Image leaking_image() {
  Image image = floor_image();
  auto visibility = image.add_plane("visibility");
  for (size_t i = 0; i < visibility.size(); ++i) {
    const size_t x = i % kFakeWidth_px;
    const size_t y = i / kFakeWidth_px;
    const bool is_slit = x >= 8 && x < 11 && y >= 5 && y < 25;
    visibility[i] = is_slit || x >= 25 ? 1.0f : 0.0f;
  }
  return image;
}

Image technique_image(float error) {
  Image image = floor_image();
  auto visibility = image.add_plane("visibility", 0.5f);
  for (size_t i = 0; i < visibility.size(); ++i) {
    if (i % kFakeWidth_px < 20) visibility[i] += error;
  }
  return image;
}

Frame frame_of(Image image) {
  Frame frame;
  frame.image = std::move(image);
  frame.device = "Fake device";
  frame.wall_time_s = 0.25;
  frame.memory_bytes = 4 << 20;
  return frame;
}

PreparedRun FakeRenderer::prepare(const Scene& scene, const RenderRequest& request, Progress& progress) {
  PreparedRun run;
  run.frame = render(scene, request, progress);
  if (!time_frame) return run;
  run.passes = {"map", "resolve"};
  run.timer = "fake clock";
  run.time_frame = [this, request, frame = 0]() mutable { return time_frame(request, frame++); };
  return run;
}

FakeRenderer fake_reference() {
  return FakeRenderer([](const RenderRequest&) { return frame_of(reference_image()); });
}

FakeRenderer fake_realtime(double frame_ms) {
  FakeRenderer renderer([](const RenderRequest& request) {
    if (request.technique == "broken") fail_input("does not compile", {"broken/resolve.frag", 7, 3});
    Frame frame = frame_of(technique_image(request.technique == "off" ? 0.1f : 0.0f));
    frame.parameters = request.parameters;
    return frame;
  });
  renderer.time_frame = [frame_ms](const RenderRequest&, int) {
    return std::vector<double>{0.75 * frame_ms, 0.25 * frame_ms};
  };
  return renderer;
}

SceneJob fake_scene(const std::string& name) {
  SceneJob job;
  job.name = name;
  job.scene.name = name;
  job.scene.title = "A floor";
  job.scene.hash = "0123456789abcdef";
  job.scene.camera.eye_world = {0, 10, 0};
  job.scene.lights.push_back({.name = "lamp", .type = LightType::rect});
  return job;
}

TechniqueRun fake_technique(const std::string& id, std::vector<LightType> lights) {
  return {.technique = id,
          .id = id,
          .label = id,
          .title = "Technique " + id,
          .hash = "feed",
          .parameters = {{"taps", int64_t{16}}, {"radius_texels", 2.5}, {"fit", std::string("visible")}},
          .lights = std::move(lights)};
}

ValidationPlan fake_plan(std::vector<TechniqueRun> techniques) {
  ValidationPlan plan;
  plan.quality = "quick";
  plan.picture.width_px = kFakeWidth_px;
  plan.picture.height_px = kFakeHeight_px;
  plan.picture.seed = 7;
  plan.picture.samples_per_pixel = 64;
  plan.timed_frames = 5;
  plan.techniques = std::move(techniques);
  return plan;
}

Results fake_results(const std::filesystem::path& folder) {
  const std::vector<SceneJob> scenes{fake_scene("plate")};
  const ValidationPlan plan =
      fake_plan({fake_technique("exact"), fake_technique("off"), fake_technique("broken"),
                 fake_technique("sun-only", {LightType::sun})});
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  SilentProgress progress;
  return run_validation(scenes, plan, {reference, realtime}, folder, progress);
}

}  // namespace umbrameter
