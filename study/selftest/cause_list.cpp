// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/causes.h"

namespace umbrameter {
namespace {

using enum RunPart;

CauseCase of_parameters(const std::string& name, const std::string& scene, RunPart right,
                        const TechniqueChoice& sound, const ParameterValues& wrong) {
  return {name, scene, {right}, sound, wrong, {}, {}};
}

CauseCase of_light(const std::string& name, const std::string& scene, double factor) {
  return {name, scene, {filter_size}, soft_shadows(), {}, {}, light_scaled(factor)};
}

CauseCase cause_no_bias(const std::string& scene) {
  return of_parameters("bias x 0", scene, bias, biased_shadows(),
                       {{"bias_texels", 0.0}, {"normal_offset_texels", 0.0}});
}

CauseCase cause_coarse_map(const std::string& scene) {
  return of_parameters("map too coarse", scene, map_size, soft_shadows(), {{"map_size", int64_t{128}}});
}

CauseCase cause_wide_filter(const std::string& scene) {
  return of_parameters("filter four times too wide", scene, filter_size, fixed_filter(),
                       {{"radius_texels", 32.0}});
}

CauseCase cause_wide_variance(const std::string& scene) {
  return of_parameters("variance filter five times too wide", scene, filter_size, variance_shadows(),
                       {{"filter_width_texels", 45.0}});
}

CauseCase cause_few_taps(const std::string& scene) {
  return of_parameters("few taps", scene, taps, soft_shadows(), {{"filter_taps", int64_t{4}}});
}

CauseCase search_too_small(const std::string& scene) {
  CauseCase fault = of_parameters("search radius too small", scene, blocker_distance, soft_shadows(), {});
  fault.patches = {{"blocker_search.glsl", "vec2 kernel = focused(", "vec2 kernel = 0.1 * focused("}};
  return fault;
}

CauseCase search_too_near(const std::string& scene) {
  CauseCase fault =
      of_parameters("search half as far as blockers", scene, blocker_distance, soft_shadows(), {});
  fault.patches = {{"blocker_search.glsl", "sum += is_harmonic ? 1.0 / z_blocker : z_blocker;",
                    "z_blocker = 0.5 * z_blocker; sum += is_harmonic ? 1.0 / z_blocker : z_blocker;"}};
  return fault;
}

}  // namespace

std::vector<CauseCase> cause_list() {
  return {cause_no_bias("box_contact"), cause_no_bias("slanted_plane"), cause_no_bias("colonnade"),
          of_parameters("bias x 10", "colonnade", bias, with(biased_shadows(), {{"bias_world", 0.03}}),
                        {{"bias_world", 0.3}}),
          of_parameters("normal offset x 10", "colonnade", bias, biased_shadows(),
                        {{"normal_offset_texels", 10.0}}),
          // Not box_contact: a closed box's map holds its lit faces, and no bias there makes a fault.
          of_parameters("bias too large", "fence", bias, biased_shadows(), {{"bias_texels", 32.0}}),
          of_light("light half too small", "plate", 0.5),
          of_light("light half too small", "contact_hardening", 0.5),
          of_light("light twice too large", "half_plane_disk", 2.0),
          of_light("light twice too large", "contact_hardening", 2.0),
          of_light("light twice too large", "colonnade", 2.0),
          of_parameters("kernel in texels", "half_plane", filter_size,
                        with(fixed_filter(), {{"radius_texels", 32.0}}), {{"radius_texels", 8.0}}),
          cause_wide_filter("box_contact"), cause_wide_filter("colonnade"),
          cause_wide_filter("contact_hardening"), cause_wide_variance("box_contact"),
          cause_wide_variance("colonnade"), cause_few_taps("half_plane"), cause_few_taps("contact_hardening"),
          of_parameters("few taps, no noise", "half_plane", taps, soft_shadows(),
                        {{"filter_taps", int64_t{6}}, {"noise", false}}),
          cause_coarse_map("colonnade"), cause_coarse_map("fence"), cause_coarse_map("box_contact"),
          search_too_small("half_plane_disk"), search_too_near("contact_hardening"),
          search_too_near("plate")};
}

}  // namespace umbrameter
