// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/placed_vertices.h"

#include "core/error.h"
#include "realtime/harness/instance_buffers.h"

#include <regex>

namespace umbrameter {

std::string instance_vertex_prelude() {
  return fmt::format(
      "#include \"instances.glsl\"\n"
      "layout(location = {}) in uint instance_of_vertex;\n"
      "void place_vertex();\n"
      "#define main() main_of_place(); void main() {{ place_vertex(); main_of_place(); }} void main_of_place()\n",
      kInstanceLocation);
}

std::string with_placed_vertices(const std::string& text, const std::string& file) {
  static const std::regex kDeclaration(
      R"(layout\s*\(\s*location\s*=\s*0\s*\)\s*in\s+vec3\s+([A-Za-z_]\w*)\s*;)");
  const auto found = std::distance(std::sregex_iterator(text.begin(), text.end(), kDeclaration), std::sregex_iterator());
  if (found != 1) {
    fail_input(fmt::format("the vertex shader declares its position {} times, and the scene has instances", found), {file},
               "write 'layout(location = 0) in vec3 p_world;' once");
  }
  return std::regex_replace(text, kDeclaration,
                            "layout(location = 0) in vec3 $1_in_mesh; vec3 $1; "
                            "void place_vertex() { $1 = place_world(instances[instance_of_vertex], $1_in_mesh); }");
}

}  // namespace umbrameter
