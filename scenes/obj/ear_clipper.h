// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ear clipping of a polygon in the plane.

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace umbrameter {

/// A polygon that turns left, its corners shrinking one ear at a time, round after round: the second corner comes first, and
/// a corner beside the last ear has to wait. Triangles stay short, so that few corners are near them.
class EarClipper {
 public:
  /// At least three corners, neighbours at different places.
  explicit EarClipper(std::vector<glm::dvec2> corners);
  std::vector<std::array<uint32_t, 3>> run();
  /// True when the polygon crosses itself: it goes round more or less than once, or a corner
  /// had to go that is no ear.
  bool is_guess() const { return is_guess_; }

 private:
  /// What may be clipped, best first. `touching`: another corner lies on the diagonal, its edges beyond it.
  /// `flat`: no area. `spike`: turns back on itself, the end of a slit perhaps. `blocked`: an ear if nothing lay in it.
  enum class Kind : uint8_t { ear, touching, flat, spike, blocked, reflex, gone };
  static constexpr size_t kKinds = 6;  // without `gone`

  void sort_reflex();
  Kind kind_alone(uint32_t corner) const;
  Kind classify(uint32_t corner) const;
  Kind look_into_ear(uint32_t corner) const;
  /// What `other` means for the ear at `corner`: ear (nothing), touching or blocked.
  Kind weigh(uint32_t other, uint32_t corner) const;
  void set_kind(uint32_t corner, Kind kind);
  void reclassify();
  uint32_t choose();
  void remove(uint32_t corner);

  std::vector<glm::dvec2> corners_;
  std::vector<uint32_t> before_, after_;
  std::vector<Kind> kinds_;
  std::array<std::set<uint32_t>, kKinds> by_kind_;
  std::vector<uint32_t> reflex_by_x_;  // who was reflex or a spike at the start; nobody becomes so later
  uint32_t first_ = 0;                 // the lowest corner left
  uint32_t last_ = 0;                  // looked at: the next ear comes after it
  size_t left_ = 0;
  bool is_guess_ = false;
};

}  // namespace umbrameter
