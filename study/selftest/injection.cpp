// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/injection.h"

#include "core/sampling/sobol.h"
#include "metrics/image/nearest_feature.h"
#include "metrics/image/separable_filter.h"
#include "metrics/image/surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

constexpr float kLit = 0.99f, kUmbra = 0.01f;
constexpr size_t kSlit_px = 3, kShortestSlit_px = 8, kLongestSlit_px = 40;
constexpr double kFarBlocker_px = 24.0, kGap_px = 4.0;  // extents of a pixel on the receiver
constexpr double kOpen_px = 24.0;
constexpr size_t kBlur_px = 11;
constexpr float kGrazing = 0.3f;         // of the largest irradiance
constexpr double kBentCosine = 0.99985;  // one degree
constexpr uint32_t kSpeckleOf = 500;
constexpr double kStripe_px = 6.0;
constexpr float kFaintestStripe = 0.05f;

// The truth, by pixel.
struct Reader {
  explicit Reader(const Canvas& canvas)
      : width(static_cast<size_t>(canvas.truth.width)),
        mask(canvas.mask),
        r(canvas.truth.plane("visibility")),
        blocker(canvas.truth.plane("blocker_distance_min")),
        layers(canvas.truth.plane("blocker_layers")),
        surface(checked_surface(canvas.truth)),
        normal{canvas.truth.plane("shading_normal.x"), canvas.truth.plane("shading_normal.y"),
               canvas.truth.plane("shading_normal.z")} {}

  bool lit(size_t i) const { return mask[i] != 0 && r[i] > kLit; }
  bool umbra(size_t i) const { return mask[i] != 0 && r[i] < kUmbra; }
  /// Whether shading and geometric normal differ: a smooth mesh of facets.
  bool bent(size_t i) const {
    const glm::dvec3 shading = {normal[0][i], normal[1][i], normal[2][i]};
    return glm::dot(shading, surface.n_world(i)) < kBentCosine;
  }
  bool blocked_from_far(size_t i) const {
    return umbra(i) && blocker[i] > kFarBlocker_px * pixel_extent_world(surface, i);
  }

  size_t width;
  std::span<const uint8_t> mask;
  std::span<const float> r, blocker, layers;
  SurfaceView surface;
  std::array<std::span<const float>, 3> normal;
};

// paint(v, i) gives the new visibility of pixels where `where` holds.
template <class Where, class Paint>
Injected painted(const Canvas& canvas, const Where& where, const Paint& paint) {
  Injected out = {canvas.picture, std::vector<uint8_t>(canvas.mask.size(), 0)};
  const std::span<float> v = out.picture.plane("visibility");
  for (size_t i = 0; i < v.size(); ++i) {
    if (canvas.mask[i] == 0 || !where(i)) continue;
    v[i] = std::clamp(paint(v[i], i), 0.0f, 1.0f);
    out.pixels[i] = 1;
  }
  return out;
}

float full_light(float, size_t) {
  return 1.0f;
}

uint32_t random_of(size_t i) {
  return hash_combine(0, static_cast<uint32_t>(i));
}

struct Slit {
  size_t x = 0, y0 = 0, length = 0;
};

// The longest run of rows whose three pixels from x on are all blocked from far.
Slit longest_slit(const Reader& reader, size_t height) {
  Slit best;
  for (size_t x = 0; x + kSlit_px <= reader.width; ++x) {
    size_t length = 0;
    for (size_t y = 0; y < height; ++y) {
      const size_t i = y * reader.width + x;
      const bool is_free =
          reader.blocked_from_far(i) && reader.blocked_from_far(i + 1) && reader.blocked_from_far(i + 2);
      length = is_free ? length + 1 : 0;
      if (length > best.length) best = {x, y + 1 - length, length};
    }
  }
  return best;
}

float stripe(size_t i, size_t width) {
  const double phase = (static_cast<double>(i % width) + 0.7 * static_cast<double>(i / width)) / kStripe_px;
  return 0.25f * static_cast<float>(std::sin(2.0 * std::numbers::pi * phase));
}

float half_dark(float v, size_t) {
  return v - 0.5f;
}

template <class Where>
Injected striped(const Canvas& canvas, const Where& where) {
  const size_t width = static_cast<size_t>(canvas.truth.width);
  return painted(
      canvas,
      [&](size_t i) {
        const size_t x = i % width;
        const bool is_middle = x >= width / 4 && x < width - width / 4;
        return is_middle && where(i) && stripe(i, width) > kFaintestStripe;
      },
      [&](float v, size_t i) { return v - stripe(i, width); });
}

std::vector<uint8_t> open_ground(const Reader& reader, const Image& truth) {
  std::vector<uint8_t> shaded(reader.mask.size()), open(reader.mask.size());
  for (size_t i = 0; i < shaded.size(); ++i) shaded[i] = reader.mask[i] != 0 && !reader.lit(i) ? 1 : 0;
  const std::vector<int32_t> nearest = nearest_feature(shaded, truth.width, truth.height);
  for (size_t i = 0; i < open.size(); ++i) {
    const bool is_far =
        nearest[i] < 0 || distance_px(static_cast<int64_t>(i), nearest[i], truth.width) >= kOpen_px;
    open[i] = reader.lit(i) && is_far ? 1 : 0;
  }
  return open;
}

}  // namespace

size_t Injected::count() const {
  return static_cast<size_t>(std::count(pixels.begin(), pixels.end(), uint8_t{1}));
}

// Its middle, where it is long: ends lie in the penumbra's reach.
Injected light_leak_slit(const Canvas& canvas) {
  const Reader reader(canvas);
  Slit slit = longest_slit(reader, static_cast<size_t>(canvas.truth.height));
  if (slit.length < kShortestSlit_px) slit.length = 0;
  const size_t length = std::min(slit.length, kLongestSlit_px);
  slit.y0 += (slit.length - length) / 2;
  return painted(
      canvas,
      [&](size_t i) {
        const size_t x = i % reader.width, y = i / reader.width;
        return x >= slit.x && x < slit.x + kSlit_px && y >= slit.y0 && y < slit.y0 + length;
      },
      full_light);
}

Injected speckle(const Canvas& canvas) {
  const Reader reader(canvas);
  return painted(
      canvas, [&](size_t i) { return reader.lit(i) && random_of(i) % kSpeckleOf == 0; }, half_dark);
}

Injected speckle_in_the_open(const Canvas& canvas) {
  const Reader reader(canvas);
  const std::vector<uint8_t> open = open_ground(reader, canvas.truth);
  return painted(
      canvas, [&](size_t i) { return open[i] != 0 && random_of(i) % (kSpeckleOf / 5) == 0; }, half_dark);
}

Injected stripes(const Canvas& canvas) {
  const Reader reader(canvas);
  return striped(canvas, [&](size_t i) { return reader.lit(i); });
}

Injected stripes_in_the_open(const Canvas& canvas) {
  const std::vector<uint8_t> open = open_ground(Reader(canvas), canvas.truth);
  return striped(canvas, [&](size_t i) { return open[i] != 0; });
}

Injected contact_gap(const Canvas& canvas) {
  const Reader reader(canvas);
  return painted(
      canvas,
      [&](size_t i) {
        return reader.r[i] < 0.5f && reader.blocker[i] > 0.0f &&
               reader.blocker[i] < kGap_px * pixel_extent_world(reader.surface, i);
      },
      full_light);
}

Injected bleeding(const Canvas& canvas) {
  const Reader reader(canvas);
  return painted(
      canvas, [&](size_t i) { return reader.umbra(i) && reader.layers[i] >= 2.0f; },
      [](float v, size_t) { return v + 0.15f; });
}

Injected picture_blur(const Canvas& canvas) {
  const Kernel box = {std::vector<float>(kBlur_px, 1.0f / static_cast<float>(kBlur_px))};
  const int width = canvas.picture.width, height = canvas.picture.height;
  const std::vector<float> once = filter(canvas.picture.plane("visibility"), width, height, box, box);
  const std::vector<float> twice = filter(once, width, height, box, box);
  return painted(
      canvas, [](size_t) { return true; }, [&](float, size_t i) { return twice[i]; });
}

Injected terminator_cured(const Canvas& canvas) {
  const Reader reader(canvas);
  const auto irradiance = canvas.truth.plane("unshadowed_irradiance");
  float largest = 0.0f;
  for (size_t i = 0; i < irradiance.size(); ++i)
    largest = reader.mask[i] != 0 ? std::max(largest, irradiance[i]) : largest;
  return painted(
      canvas,
      [&](size_t i) {
        return reader.bent(i) && irradiance[i] < kGrazing * largest &&
               (reader.layers[i] == 0.0f ||
                reader.blocker[i] < kGap_px * pixel_extent_world(reader.surface, i));
      },
      full_light);
}

Injected jitter(const Canvas& canvas) {
  return painted(
      canvas, [](size_t) { return true; },
      [](float v, size_t i) { return v + (static_cast<float>(random_of(i) % 3) - 1.0f) / 255.0f; });
}

}  // namespace umbrameter
