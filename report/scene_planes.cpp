// SPDX-License-Identifier: Apache-2.0
#include "report/scene_planes.h"

#include "core/image_io.h"
#include "metrics/penumbra/width_pairs.h"
#include "report/plane_code.h"
#include "results/pictures/picture_classes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kSmallWidth_px = 240;      // of the pictures at the head of the page, at least
constexpr double kSmallSteps = 255.0;    // in which their planes are kept
constexpr size_t kMostWidthPairs = 256;  // of a run; a plot of more is a blot

/// Planes on their way into the store, with how to read them.
struct Parcel {
  PackedPlanes planes;
  OrderedJson codes = OrderedJson::object();

  void add(const std::string& name, std::span<const float> values, const PlaneCode& code) {
    planes[name] = pack_plane(values, code);
    codes[name] = {{"low", code.low}, {"step", code.step}, {"delta", code.is_delta}};
  }
  void add(const std::string& name, std::span<const uint8_t> bytes) {
    planes[name] = pack_bytes(bytes);
    codes[name] = {{"bytes", true}};
  }
};

template <class Class>
std::vector<uint8_t> bytes_of(const std::vector<Class>& classes) {
  std::vector<uint8_t> bytes;
  for (const Class item : classes) bytes.push_back(static_cast<uint8_t>(item));
  return bytes;
}

std::vector<uint8_t> hit_pixels(const Image& image) {
  std::vector<uint8_t> hit(image.pixel_count(), 1);
  if (!image.has("primitive_id")) return hit;
  const auto primitive = image.plane("primitive_id");
  for (size_t i = 0; i < hit.size(); ++i) hit[i] = primitive[i] < 0.0f ? 0 : 1;
  return hit;
}

/// 1023 steps up to the largest: the lit picture is for the eye, and fewer steps pack better.
PlaneCode lit_code(const Image& reference) {
  const auto irradiance = reference.plane("unshadowed_irradiance");
  const float largest = irradiance.empty() ? 0.0f : *std::ranges::max_element(irradiance);
  return {0.0, largest > 0.0f ? largest / 1023.0 : 1.0, true};
}

Parcel reference_parcel(const Image& reference, const SceneResult& scene,
                        const std::filesystem::path& folder) {
  Parcel parcel;
  parcel.add("visibility", reference.plane("visibility"), kReferenceVisibilityCode);
  parcel.add("hit", hit_pixels(reference));
  for (const char* name : {"visibility_se", "blocker_distance"}) {
    if (reference.has(name)) parcel.add(name, reference.plane(name), kHalfCode);
  }
  for (const char* name : {"position.x", "position.y", "position.z"}) {
    if (reference.has(name)) parcel.add(name, reference.plane(name), range_code(reference.plane(name)));
  }
  if (reference.has("unshadowed_irradiance")) {
    parcel.add("unshadowed", reference.plane("unshadowed_irradiance"), lit_code(reference));
  }
  if (scene.parity && !scene.parity->picture_file.empty()) {
    parcel.add("parity", bytes_of(read_parity_picture(folder / scene.parity->picture_file)));
  }
  return parcel;
}

/// Means over squares of `side` pixels, what does not fill one left out. `weight`: 0 for pixels that do not count.
std::vector<float> block_means(std::span<const float> plane, std::span<const uint8_t> weight, int width,
                               int height, int side) {
  std::vector<float> means;
  for (int y = 0; y + side <= height; y += side) {
    for (int x = 0; x + side <= width; x += side) {
      double sum = 0.0;
      int count = 0;
      for (int k = 0; k < side * side; ++k) {
        const size_t i = static_cast<size_t>(y + k / side) * static_cast<size_t>(width) +
                         static_cast<size_t>(x + k % side);
        if (weight[i] == 0) continue;
        sum += static_cast<double>(plane[i]);
        ++count;
      }
      means.push_back(count > 0 ? static_cast<float>(sum / count) : 0.0f);
    }
  }
  return means;
}

/// What a small lit picture is painted from, inside the page's data, so that it is there before the pixels are read.
OrderedJson small_picture(const Image& reference) {
  const int side = std::max(1, reference.width / kSmallWidth_px);
  const std::vector<uint8_t> hit = hit_pixels(reference), all(hit.size(), 1);
  const std::vector<float> solid(hit.begin(), hit.end());
  const auto means = [&](std::span<const float> plane, const std::vector<uint8_t>& weight) {
    return block_means(plane, weight, reference.width, reference.height, side);
  };
  Parcel parcel;
  parcel.add("visibility", means(reference.plane("visibility"), hit), {0.0, 1.0 / kSmallSteps, true});
  std::vector<uint8_t> is_solid;
  for (const float share : means(solid, all)) is_solid.push_back(share >= 0.5f ? 1 : 0);
  parcel.add("hit", is_solid);
  if (reference.has("unshadowed_irradiance")) {
    const std::vector<float> light = means(reference.plane("unshadowed_irradiance"), hit);
    const float largest = light.empty() ? 0.0f : *std::ranges::max_element(light);
    parcel.add("unshadowed", light, {0.0, largest > 0.0f ? largest / kSmallSteps : 1.0, true});
  }
  return {{"width", reference.width / side},
          {"height", reference.height / side},
          {"planes", parcel.codes},
          {"packed", parcel.planes}};
}

/// Evenly picked from those sorted by width.
OrderedJson widths_json(const std::vector<WidthPair>& pairs) {
  OrderedJson list = OrderedJson::array();
  const size_t count = std::min(pairs.size(), kMostWidthPairs);
  const auto rounded = [](double width) { return std::stod(fmt::format("{:.4g}", width)); };
  for (size_t k = 0; k < count; ++k) {
    const WidthPair& pair = pairs[count == 1 ? 0 : k * (pairs.size() - 1) / (count - 1)];
    list.push_back({rounded(pair.reference_world), rounded(pair.test_world)});
  }
  return list;
}

/// From the error picture of a validation, or the plane that a sweep stores. Absent for a run that was not compared.
std::optional<std::vector<uint8_t>> scored_pixels(const TechniqueResult& run, const Image& image,
                                                  const std::filesystem::path& folder) {
  if (!run.error_picture_file.empty()) return read_scored_pixels(folder / run.error_picture_file);
  if (!run.error || !image.has("scored")) return std::nullopt;
  std::vector<uint8_t> scored;
  for (const float is_scored : image.plane("scored")) scored.push_back(is_scored > 0.0f ? 1 : 0);
  return scored;
}

OrderedJson add_run(const TechniqueResult& run, const std::string& id, const Image& reference,
                    const std::filesystem::path& folder, PlaneStore& store) {
  if (run.image_file.empty()) return nullptr;
  const Image image = read_image(folder / run.image_file);
  require_same_size(image, reference, run.image_file);
  Parcel parcel;
  parcel.add("visibility", image.plane("visibility"), kTestVisibilityCode);
  std::vector<WidthPair> pairs;
  if (const auto scored = scored_pixels(run, image, folder)) {
    parcel.add("scored", *scored);
    if (run.diagnosis) pairs = measure_width_pairs(image, reference, *scored);
  }
  if (!run.fault_picture_file.empty()) {
    parcel.add("faults", bytes_of(read_fault_picture(folder / run.fault_picture_file)));
  }
  store.add(id, parcel.planes);
  return {{"id", id}, {"planes", parcel.codes}, {"widths", widths_json(pairs)}, {"profiles", pairs.size()}};
}

}  // namespace

OrderedJson add_scene_planes(const SceneResult& scene, size_t scene_index,
                             const std::filesystem::path& folder, PlaneStore& store) {
  if (!scene.reference) return nullptr;
  const Image reference = read_image(folder / scene.reference->image_file);
  const Parcel parcel = reference_parcel(reference, scene, folder);
  const std::string id = fmt::format("s{}", scene_index);
  store.add(id, parcel.planes);
  OrderedJson runs = OrderedJson::array();
  for (const TechniqueResult& run : scene.techniques) {
    runs.push_back(add_run(run, fmt::format("{}-r{}", id, runs.size()), reference, folder, store));
  }
  return {{"id", id},
          {"width", reference.width},
          {"height", reference.height},
          {"planes", parcel.codes},
          {"small", small_picture(reference)},
          {"runs", runs}};
}

}  // namespace umbrameter
