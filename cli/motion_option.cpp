// SPDX-License-Identifier: Apache-2.0
#include "cli/motion_option.h"

#include "scenes/motion.h"

namespace umbrameter {

void add_motion_option(CLI::App& verb, std::string& motion) {
  const auto names = motion_names();
  verb.add_option(
          "--motion", motion,
          "what moved in the frames before the picture, for techniques that carry history: nothing "
          "(still), the camera (pan), the whole view (cut), the light, the scene's object, or what the "
          "scene's [motion] says (script); none = script, else still")
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
}

}  // namespace umbrameter
