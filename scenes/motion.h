// SPDX-License-Identifier: Apache-2.0
#pragma once
// What moves from frame to frame, in closed form. A picture is of the last frame, 0, where all stands as the scene says; frames
// before it count -1, -2, ... For techniques that carry history, and for the sequences of `--temporal`.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace umbrameter {

struct Scene;  // scenes/scene.h

/// Steps a frame. What is 0 stands still.
struct Motion {
  std::string name = "still";
  glm::dvec2 camera_step_px{0.0};     // right and up, measured at what the camera looks at
  glm::dvec3 camera_step_world{0.0};  // besides
  bool is_cut = false;                // before the last frame the camera looks the other way
  glm::dvec3 light_step_world{0.0};   // of the active light, unless it is a sun
  double sun_step_rad = 0.0;          // turns the active sun about its bitangent
  std::string object = {};            // a part of the scene
  glm::dvec3 object_step_world{0.0};
  std::optional<int> frames_before =
      {};  // drawn before the last one, instead of as many as the technique asks for
};

/// "still", "pan", "cut", "light", "object", "script".
std::span<const std::string> motion_names();

/// A motion of that name for any scene. The camera pans by 3.618 px aside and 1.414 px up a frame; a light moves by 0.618 % of
/// its distance from what the camera looks at, along its tangent; a sun turns by 0.354 degrees: irrational steps, so that no
/// texel snaps onto itself. object: that of the scene's own motion; script: all of it. Error{input} for an unknown name, and for a
/// scene that does not say which object moves, or nothing at all.
Motion standard_motion(std::string_view name, const Scene& scene);

/// The scene as it stands in frame `frame` of its motion, in a picture `height_px` high; what moves on keeps its motion. Only a
/// moving object costs a copy of the positions.
Scene scene_at(const Scene& scene, int frame, int height_px);

}  // namespace umbrameter
