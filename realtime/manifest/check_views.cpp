// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/check_technique.h"
#include "realtime/views/light_view.h"

#include <algorithm>

namespace umbrameter {
namespace {

/// The view's fit, or all that its parameter offers.
std::vector<LightFit> fits_of(const Technique& technique, const ViewDeclaration& view) {
  const auto parameter = std::ranges::find(technique.parameters, view.fit, &Parameter::name);
  if (parameter == technique.parameters.end()) return {find_light_fit(view.fit)};
  std::vector<LightFit> fits;
  for (const std::string& choice : parameter->choices) fits.push_back(find_light_fit(choice));
  return fits;
}

/// Faces are those of a light with a place; slices of the frustum are for lights with none.
void check_coverage(const Technique& technique, const ViewDeclaration& view) {
  const auto fail_view = [&](const std::string& message, const std::string& hint) {
    fail_input(fmt::format("view '{}' {}", view.name, message), view.where, hint);
  };
  const bool is_around = view.from == ViewOrigin::light_face || view.from == ViewOrigin::light_half;
  if (is_around && technique.supports(LightType::sun))
    fail_view("looks all around the light, which a sun has no place for", "leave \"sun\" out of 'lights'");
  const bool is_sun_only = technique.lights.size() == 1 && technique.supports(LightType::sun);
  if (view.slice_world && !is_sun_only)
    fail_view("covers a slice of the frustum, which only a sun's can", "lights = [\"sun\"]");
  if (is_around) return;
  for (const LightFit fit : fits_of(technique, view)) {
    const std::string& name = light_fits()[static_cast<size_t>(fit)];
    if (view.slice_world && !follows_slice(fit))
      fail_view(fmt::format("has the fit '{}', which follows no slice", name),
                "frustum, full, visible or sphere");
    if (!view.slice_world && fit == LightFit::sphere)
      fail_view("has the fit 'sphere' without a slice", "add 'slice_world'");
  }
}

}  // namespace

void check_views(const Technique& technique) {
  for (const ViewDeclaration& view : technique.views) check_coverage(technique, view);
}

}  // namespace umbrameter
