// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/penumbra_walk.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace umbrameter {

namespace {

constexpr size_t kPlateauRun = 3;
constexpr double kPlateau = 0.002;     // of the reference, beside two standard errors
constexpr double kTestPlateau = 0.01;  // of the test
constexpr double kTurn = 0.05;         // fall from the extreme, beside four standard errors, that ends a walk
constexpr int kLargestWindowPx = 64;
constexpr int kWindowSamples = 6;  // to either side

struct Cursor {
  const SurfaceView& surface;
  int x = 0, y = 0;

  Cursor(const SurfaceView& view, size_t pixel)
      : surface(view),
        x(static_cast<int>(pixel % static_cast<size_t>(view.width))),
        y(static_cast<int>(pixel / static_cast<size_t>(view.width))) {}

  std::optional<size_t> at(int dx, int dy) const {
    const int px = x + dx, py = y + dy;
    if (px < 0 || py < 0 || px >= surface.width || py >= surface.height) return std::nullopt;
    return static_cast<size_t>(py) * static_cast<size_t>(surface.width) + static_cast<size_t>(px);
  }
};

bool crosses(const ReferenceField& field, size_t i, std::optional<size_t> neighbour, float level) {
  if (!neighbour || !field.connected(i, *neighbour)) return false;
  const float a = field.visibility[i] - level, b = field.visibility[*neighbour] - level;
  return a != b && a * b <= 0.0f;
}

bool crosses(const ReferenceField& field, size_t i, float level) {
  const Cursor cursor(field.surface, i);
  return crosses(field, i, cursor.at(1, 0), level) || crosses(field, i, cursor.at(0, 1), level);
}

/// The flank's level that the visibility is closest to.
float flank_level(float visibility) {
  return visibility < 0.5f ? 0.25f : 0.75f;
}

// Change of position a pixel step brings, central where both neighbours belong to the surface.
std::optional<glm::dvec3> pixel_step(const ReferenceField& field, size_t seed, int dx, int dy) {
  const Cursor cursor(field.surface, seed);
  size_t from = seed, to = seed;
  double pixels = 0.0;
  if (const auto ahead = cursor.at(dx, dy); ahead && field.connected(seed, *ahead)) {
    to = *ahead;
    pixels += 1.0;
  }
  if (const auto behind = cursor.at(-dx, -dy); behind && field.connected(seed, *behind)) {
    from = *behind;
    pixels += 1.0;
  }
  if (pixels == 0.0) return std::nullopt;
  return (field.surface.p_world(to) - field.surface.p_world(from)) / pixels;
}

// Orthonormal tangents of the receiver and the image step that moves by one along each.
struct TangentFrame {
  std::array<glm::dvec3, 2> tangent;
  std::array<glm::dvec2, 2> px_from_tangent;  // columns
};

std::optional<TangentFrame> tangent_frame(const ReferenceField& field, size_t seed) {
  const auto step_x = pixel_step(field, seed, 1, 0), step_y = pixel_step(field, seed, 0, 1);
  if (!step_x || !step_y) return std::nullopt;
  const glm::dvec3 normal = field.surface.n_world(seed);
  const glm::dvec3 along = *step_x - normal * glm::dot(normal, *step_x);
  if (!(glm::length(along) > 0.0)) return std::nullopt;
  TangentFrame frame;
  frame.tangent[0] = glm::normalize(along);
  frame.tangent[1] = glm::cross(normal, frame.tangent[0]);
  const double a = glm::dot(frame.tangent[0], *step_x), b = glm::dot(frame.tangent[0], *step_y);
  const double c = glm::dot(frame.tangent[1], *step_x), d = glm::dot(frame.tangent[1], *step_y);
  const double determinant = a * d - b * c;
  // Edge on: a pixel along the surface is a thousand across.
  if (!(std::abs(determinant) > 1e-3 * (a * a + b * b + c * c + d * d))) return std::nullopt;
  frame.px_from_tangent = {glm::dvec2{d, -c} / determinant, glm::dvec2{-b, a} / determinant};
  return frame;
}

// Slope of visibility over the tangent plane, by least squares over a disc of pixels.
std::optional<glm::dvec2> fit_slope(const ReferenceField& field, size_t seed, const TangentFrame& frame,
                                    int radius_px) {
  const Cursor cursor(field.surface, seed);
  const glm::dvec3 origin = field.surface.p_world(seed);
  const int stride = std::max(1, radius_px / kWindowSamples);
  double n = 0, sa = 0, sb = 0, sv = 0, saa = 0, sab = 0, sbb = 0, sav = 0, sbv = 0;
  for (int dy = -radius_px; dy <= radius_px; dy += stride) {
    for (int dx = -radius_px; dx <= radius_px; dx += stride) {
      if (dx * dx + dy * dy > radius_px * radius_px) continue;
      const auto i = cursor.at(dx, dy);
      if (!i || !field.connected(seed, *i)) continue;
      const glm::dvec3 offset = field.surface.p_world(*i) - origin;
      const double a = glm::dot(frame.tangent[0], offset), b = glm::dot(frame.tangent[1], offset);
      const double v = field.visibility[*i];
      n += 1.0, sa += a, sb += b, sv += v;
      saa += a * a, sab += a * b, sbb += b * b, sav += a * v, sbv += b * v;
    }
  }
  if (n < 3.0) return std::nullopt;
  const double caa = saa - sa * sa / n, cab = sab - sa * sb / n, cbb = sbb - sb * sb / n;
  const double cav = sav - sa * sv / n, cbv = sbv - sb * sv / n;
  const double determinant = caa * cbb - cab * cab;
  if (!(determinant > 1e-9 * caa * cbb)) return std::nullopt;
  return glm::dvec2{cav * cbb - cbv * cab, cbv * caa - cav * cab} / determinant;
}

// Follows one side's plateau and turning point.
class SideWatch {
 public:
  explicit SideWatch(bool towards_light) : towards_light_(towards_light) {}

  /// How far from this side's plateau a visibility is.
  double distance(double visibility) const { return towards_light_ ? 1.0 - visibility : visibility; }

  bool turned(double visibility, double se, size_t samples) {
    if (distance(visibility) < nearest_) {
      nearest_ = distance(visibility);
      samples_to_nearest_ = samples;
    }
    return distance(visibility) > nearest_ + kTurn + 4.0 * se;
  }
  /// Samples of the walk up to its extreme.
  size_t samples_to_nearest() const { return samples_to_nearest_; }
  /// True from the kPlateauRun-th pixel in a row within `tolerance` of the plateau.
  static bool settled(double distance, double tolerance, size_t& run) {
    run = distance <= tolerance ? run + 1 : 0;
    return run >= kPlateauRun;
  }

 private:
  bool towards_light_;
  double nearest_ = 1.0;
  size_t samples_to_nearest_ = 0;
};

}  // namespace

std::optional<Seed> find_seed(const ReferenceField& field, const Tile& cell) {
  std::optional<Seed> best;
  std::optional<size_t> flank;
  float best_distance = 0.3f, flank_distance = 1.0f;
  for (int y = cell.y0; y < cell.y1; ++y) {
    for (int x = cell.x0; x < cell.x1; ++x) {
      const size_t i =
          static_cast<size_t>(y) * static_cast<size_t>(field.surface.width) + static_cast<size_t>(x);
      if (!field.usable(i)) continue;
      const float level = flank_level(field.visibility[i]);
      const float from_flank = std::abs(field.visibility[i] - level);
      if (from_flank < flank_distance && crosses(field, i, level)) {
        flank = i;
        flank_distance = from_flank;
      }
      const float distance = std::abs(field.visibility[i] - 0.5f);
      const bool ridge = crosses(field, i, 0.5f);
      const bool better = ridge != (best && best->on_ridge) ? ridge : distance < best_distance;
      if (!better) continue;
      best = Seed{i, ridge, {}};
      best_distance = distance;
    }
  }
  if (best && !best->on_ridge) best->flank = flank;
  return best;
}

std::optional<Ascent> fit_ascent(const ReferenceField& field, size_t seed) {
  const auto frame = tangent_frame(field, seed);
  if (!frame) return std::nullopt;
  std::optional<Ascent> ascent;
  for (int radius_px = 2; radius_px <= kLargestWindowPx; radius_px *= 2) {
    const auto slope = fit_slope(field, seed, *frame, radius_px);
    if (!slope || !(glm::length(*slope) > 0.0)) break;
    const glm::dvec2 unit = glm::normalize(*slope);
    const glm::dvec2 px = frame->px_from_tangent[0] * unit.x + frame->px_from_tangent[1] * unit.y;
    ascent = Ascent{frame->tangent[0] * unit.x + frame->tangent[1] * unit.y,
                    px / std::max(std::abs(px.x), std::abs(px.y)), glm::length(px) / glm::length(*slope)};
    if (radius_px >= 0.25 * ascent->width_px) break;
  }
  return ascent;
}

Walk walk_profile(const ReferenceField& field, std::span<const float> test, size_t seed, const Ascent& ascent,
                  bool towards_light, int max_length_px) {
  Walk walk;
  SideWatch watch(towards_light);
  const Cursor cursor(field.surface, seed);
  const glm::dvec3 origin = field.surface.p_world(seed);
  const glm::dvec2 step = towards_light ? ascent.direction_px : -ascent.direction_px;
  size_t reference_run = 0, test_run = 0, previous = seed;
  walk.test_cut = true;
  for (int k = 1; k <= max_length_px; ++k) {
    const auto i =
        cursor.at(static_cast<int>(std::lround(k * step.x)), static_cast<int>(std::lround(k * step.y)));
    const bool settled = walk.reference_count > 0;
    if (!i || !field.connected(previous, *i)) {
      if (!settled) walk.end = WalkEnd::broken;
      break;
    }
    const double visibility = field.visibility[*i], se = field.visibility_se[*i];
    if (watch.turned(visibility, se, walk.samples.size() + 1)) {
      if (!settled) {
        walk.end = WalkEnd::turned;
        walk.samples.resize(std::min(walk.samples.size(), watch.samples_to_nearest()));
        walk.test_count = std::min(walk.test_count, walk.samples.size());
      }
      break;
    }
    walk.samples.push_back({*i, glm::dot(ascent.direction_world, field.surface.p_world(*i) - origin)});
    previous = *i;
    if (!settled && SideWatch::settled(watch.distance(visibility), kPlateau + 2.0 * se, reference_run)) {
      walk.reference_count = walk.samples.size();
      walk.end = WalkEnd::saturated;
    }
    if (walk.test_count == 0 && SideWatch::settled(watch.distance(test[*i]), kTestPlateau, test_run)) {
      walk.test_count = walk.samples.size();
    }
    if (walk.reference_count == 0) continue;
    if (walk.test_count > 0 || walk.samples.size() >= 4 * walk.reference_count + 8) {
      walk.test_cut = false;
      break;
    }
  }
  if (walk.reference_count == 0) walk.reference_count = walk.samples.size();
  if (walk.test_count == 0) walk.test_count = walk.samples.size();
  return walk;
}

}  // namespace umbrameter
