// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/ear_clipper.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

using glm::dvec2;

/// Twice the signed area; positive when a, b, c turn left. Wider than double: its sign decides.
long double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  using Wide = long double;
  return (Wide{b.x} - Wide{a.x}) * (Wide{c.y} - Wide{a.y}) -
         (Wide{b.y} - Wide{a.y}) * (Wide{c.x} - Wide{a.x});
}

/// Whether the edges go round once to the left; true where one turns back on itself, which has no side.
bool goes_round_once(const std::vector<dvec2>& corners) {
  double angle_rad = 0.0;
  dvec2 edge = corners.front() - corners.back();
  for (size_t i = 0; i < corners.size(); ++i) {
    const dvec2 next = corners[(i + 1) % corners.size()] - corners[i];
    const double sine = edge.x * next.y - edge.y * next.x;
    const double cosine = glm::dot(edge, next);
    if (sine == 0.0 && cosine <= 0.0) return true;
    angle_rad += std::atan2(sine, cosine);
    edge = next;
  }
  return std::abs(angle_rad - 2.0 * std::numbers::pi) < 1.0;
}

}  // namespace

EarClipper::EarClipper(std::vector<dvec2> corners)
    : corners_(std::move(corners)),
      before_(corners_.size()),
      after_(corners_.size()),
      kinds_(corners_.size(), Kind::gone),
      left_(corners_.size()),
      is_guess_(!goes_round_once(corners_)) {
  const auto count = static_cast<uint32_t>(corners_.size());
  for (uint32_t i = 0; i < count; ++i) {
    before_[i] = (i + count - 1) % count;
    after_[i] = (i + 1) % count;
  }
  sort_reflex();
  for (uint32_t i = 0; i < count; ++i) set_kind(i, classify(i));
}

void EarClipper::sort_reflex() {
  for (uint32_t i = 0; i < corners_.size(); ++i) {
    kinds_[i] = kind_alone(i);
    if (kinds_[i] == Kind::reflex || kinds_[i] == Kind::spike) reflex_by_x_.push_back(i);
  }
  std::sort(reflex_by_x_.begin(), reflex_by_x_.end(), [this](uint32_t i, uint32_t j) {
    return corners_[i].x < corners_[j].x || (corners_[i].x == corners_[j].x && i < j);
  });
}

/// As if there were no other corners.
EarClipper::Kind EarClipper::kind_alone(uint32_t corner) const {
  const dvec2 &a = corners_[before_[corner]], &b = corners_[corner], &c = corners_[after_[corner]];
  const long double area = turn(a, b, c);
  if (area != 0.0L) return area > 0.0L ? Kind::ear : Kind::reflex;
  return glm::dot(b - a, c - b) > 0.0 ? Kind::flat : Kind::spike;
}

EarClipper::Kind EarClipper::classify(uint32_t corner) const {
  const Kind kind = kind_alone(corner);
  return kind == Kind::ear ? look_into_ear(corner) : kind;
}

/// Whatever reaches into the ear has a reflex corner or a spike in it, the one farthest from the diagonal.
EarClipper::Kind EarClipper::look_into_ear(uint32_t corner) const {
  const auto [left, right] =
      std::minmax({corners_[before_[corner]].x, corners_[corner].x, corners_[after_[corner]].x});
  auto other = std::lower_bound(reflex_by_x_.begin(), reflex_by_x_.end(), left,
                                [this](uint32_t i, double x) { return corners_[i].x < x; });
  Kind worst = Kind::ear;
  for (; other != reflex_by_x_.end() && corners_[*other].x <= right; ++other) {
    if (kinds_[*other] != Kind::reflex && kinds_[*other] != Kind::spike) continue;
    worst = std::max(worst, weigh(*other, corner));
    if (worst == Kind::blocked) return worst;
  }
  return worst;
}

EarClipper::Kind EarClipper::weigh(uint32_t other, uint32_t corner) const {
  const uint32_t ends[2] = {before_[corner], after_[corner]};
  if (other == corner || other == ends[0] || other == ends[1]) return Kind::ear;
  const dvec2 &p = corners_[other], &a = corners_[ends[0]], &b = corners_[corner], &c = corners_[ends[1]];
  // At the place of a corner of the ear its edges cannot lead into the ear without crossing.
  if (p == a || p == b || p == c) return Kind::ear;
  const long double from_diagonal = turn(c, a, p);
  if (from_diagonal < 0.0L || turn(a, b, p) < 0.0L || turn(b, c, p) < 0.0L) return Kind::ear;
  if (from_diagonal > 0.0L) return Kind::blocked;
  const bool is_beyond =
      turn(c, a, corners_[before_[other]]) <= 0.0L && turn(c, a, corners_[after_[other]]) <= 0.0L;
  return is_beyond ? Kind::touching : Kind::blocked;
}

void EarClipper::set_kind(uint32_t corner, Kind kind) {
  const Kind old = kinds_[corner];
  if (old != Kind::gone) by_kind_[static_cast<size_t>(old)].erase(corner);
  kinds_[corner] = kind;
  if (kind != Kind::gone) by_kind_[static_cast<size_t>(kind)].insert(corner);
}

void EarClipper::reclassify() {
  for (uint32_t i = first_, count = 0; count < left_; i = after_[i], ++count) set_kind(i, classify(i));
}

uint32_t EarClipper::choose() {
  const auto has_clean = [this] {
    return std::any_of(by_kind_.begin(), by_kind_.begin() + static_cast<size_t>(Kind::blocked),
                       [](const std::set<uint32_t>& kind) { return !kind.empty(); });
  };
  if (!is_guess_ && !has_clean()) {
    reclassify();
    is_guess_ = !has_clean();
  }
  const auto corners = std::find_if(by_kind_.begin(), by_kind_.end(),
                                    [](const std::set<uint32_t>& kind) { return !kind.empty(); });
  const auto next = corners->upper_bound(last_);
  return next == corners->end() ? *corners->begin() : *next;
}

void EarClipper::remove(uint32_t corner) {
  const uint32_t before = before_[corner];
  const uint32_t after = after_[corner];
  set_kind(corner, Kind::gone);
  after_[before] = after;
  before_[after] = before;
  --left_;
  last_ = after;
  if (corner == first_) first_ = after;
  set_kind(before, classify(before));
  set_kind(after, classify(after));
}

std::vector<std::array<uint32_t, 3>> EarClipper::run() {
  std::vector<std::array<uint32_t, 3>> triangles;
  triangles.reserve(corners_.size() - 2);
  while (left_ > 3) {
    const uint32_t ear = choose();
    triangles.push_back({before_[ear], ear, after_[ear]});
    remove(ear);
  }
  is_guess_ |= kinds_[first_] == Kind::reflex;  // the three left agree, whichever is asked
  triangles.push_back({first_, after_[first_], before_[first_]});
  return triangles;
}

}  // namespace umbrameter
