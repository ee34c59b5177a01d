// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/placed_vertices.h"

#include "core/error.h"
#include "realtime/harness/cutout_buffers.h"
#include "realtime/harness/instance_buffers.h"
#include "realtime/harness/wrapped_main.h"

#include <regex>

namespace umbrameter {

std::string instance_vertex_prelude(bool has_holes) {
  constexpr const char* kPlace = "place_vertex();";
  return fmt::format(
             "#include \"instances.glsl\"\nlayout(location = {}) in uint instance_of_vertex;\nvoid "
             "place_vertex();\n",
             kInstanceLocation) +
         (has_holes ? cutout_vertex_prelude(kPlace) : wrapped_main(kPlace, ""));
}

std::string with_placed_vertices(const std::string& text, const std::string& file) {
  static const std::regex kDeclaration(
      R"(layout\s*\(\s*location\s*=\s*0\s*\)\s*in\s+vec3\s+([A-Za-z_]\w*)\s*;)");
  const auto found =
      std::distance(std::sregex_iterator(text.begin(), text.end(), kDeclaration), std::sregex_iterator());
  if (found != 1) {
    fail_input(
        fmt::format("the vertex shader declares its position {} times, and the scene has instances", found),
        {file}, "write 'layout(location = 0) in vec3 p_world;' once");
  }
  return std::regex_replace(
      text, kDeclaration,
      "layout(location = 0) in vec3 $1_in_mesh; vec3 $1; "
      "void place_vertex() { $1 = place_world(instances[instance_of_vertex], $1_in_mesh); }");
}

}  // namespace umbrameter
