// SPDX-License-Identifier: Apache-2.0
#include "study/tune/views.h"

#include "core/error.h"
#include "core/guard.h"

#include <algorithm>
#include <array>
#include <optional>

namespace umbrameter {
namespace {

constexpr std::array kArcs_deg = {26.0, 13.0, 6.5};
constexpr std::array kSides = {-1.0, 1.0};
constexpr double kLeastShare =
    0.3;  // of the covered, the lit and the shadowed pixels of the camera that was tuned on

struct Sight {
  double scored = 0.0;
  double lit = 0.0;     // sum of visibility
  double shadow = 0.0;  // sum of what is not visible of the light
};

Sight sight_of(const View& view) {
  Sight sight;
  const auto visibility = view.reference.plane("visibility");
  for (size_t i = 0; i < view.mask.size(); ++i) {
    if (view.mask[i] == 0) continue;
    sight.scored += 1.0;
    sight.lit += static_cast<double>(visibility[i]);
    sight.shadow += 1.0 - static_cast<double>(visibility[i]);
  }
  return sight;
}

bool sees_enough(const View& view, const View& own) {
  const Sight now = sight_of(view), before = sight_of(own);
  return now.scored >= kLeastShare * before.scored && now.lit >= kLeastShare * before.lit &&
         now.shadow >= kLeastShare * before.shadow;
}

/// Absent when it is not comparable or does not see enough: it may stand in a wall.
std::optional<View> turned_view(Studio& studio, const View& own, double angle_deg) {
  std::optional<View> view;
  const auto failure = guarded([&] { view = studio.make_view(*own.job, angle_deg, own.fidelity); });
  if (failure && failure->kind != ErrorKind::input) throw Error(failure->kind, failure->message);
  return view && sees_enough(*view, own) ? std::move(view) : std::nullopt;
}

double find_reach(Studio& studio, const View& own, double side, std::vector<View>& ends) {
  for (const double angle_deg : kArcs_deg) {
    auto view = turned_view(studio, own, side * angle_deg);
    if (!view) continue;
    ends.push_back(std::move(*view));
    return angle_deg;
  }
  return 0.0;
}

std::optional<View> take_end(Arc& arc, const View& own, double angle_deg) {
  const auto end = std::ranges::find_if(arc.ends, [&](const View& view) {
    return view.angle_deg == angle_deg && view.fidelity.width_px == own.fidelity.width_px &&
           view.fidelity.reference == own.fidelity.reference;
  });
  if (end == arc.ends.end()) return std::nullopt;
  std::optional<View> view = std::move(*end);
  arc.ends.erase(end);
  return view;
}

}  // namespace

Arc find_arc(Studio& studio, const View& own) {
  Arc arc;
  arc.left_deg = find_reach(studio, own, kSides[0], arc.ends);
  arc.right_deg = find_reach(studio, own, kSides[1], arc.ends);
  return arc;
}

std::vector<View> make_turned_views(Studio& studio, const View& own, Arc& arc,
                                    std::span<const double> shares) {
  std::vector<View> views;
  for (const double share : shares) {
    for (const double angle_deg : {-arc.left_deg * share, arc.right_deg * share}) {
      if (angle_deg == 0.0) continue;
      auto view = take_end(arc, own, angle_deg);
      if (!view) view = turned_view(studio, own, angle_deg);
      if (view) views.push_back(std::move(*view));
    }
  }
  return views;
}

}  // namespace umbrameter
