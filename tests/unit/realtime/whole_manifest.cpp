// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/realtime/whole_manifest.h"

#include "core/error.h"

#include <gtest/gtest.h>

namespace umbrameter {

const std::string_view kFragment = R"(// unused_in_comments
void main() { out_visibility = softness * float(TAPS) * texture(shadow_map, vec2(0.5)).r; }
)";

std::string whole_manifest() {
  return manifest_head() + R"(constraints = ["taps <= map_size"]

[[parameter]]
name = "taps"
type = "integer"
default = 4
min = 1
max = 64
stage = "define"
doc = "Taps."

[[parameter]]
name = "softness"
type = "real"
default = 0.5
min = 0.0
max = 1.0
stage = "uniform"
doc = "Softness."

[[parameter]]
name = "map_size"
type = "integer"
default = 32
min = 16
max = 4096
stage = "host"
doc = "Map size."

[[parameter]]
name = "map_fit"
type = "choice"
choices = ["visible", "scene"]
default = "scene"
stage = "host"
doc = "Map fit."

[[view]]
name = "light"
from = "light.center"
fit = "map_fit"
size = "map_size"

[[resource]]
name = "shadow_map"
format = "depth32f"
width = "map_size"
height = "map_size"

[[pass]]
id = "map"
kind = "scene"
view = "light"
writes = ["shadow_map"]
clear = [0]

[[pass]]
id = "resolve"
kind = "fullscreen"
fragment = "resolve.frag"
views = ["light"]
reads = ["gbuffer.position", "shadow_map"]
writes = ["visibility"]

[[preset]]
name = "fine"
doc = "Fine."
[preset.values]
map_size = 1024
taps = 64
)";
}

Technique load(TechniqueFolder& folder, const std::string& manifest) {
  folder.write("technique.toml", manifest).write("resolve.frag", kFragment);
  return load_technique(folder.path(), folder.shared_folder(), TechniqueFolder::shaders_folder());
}

std::string error_of(TechniqueFolder& folder, const std::string& manifest) {
  try {
    load(folder, manifest);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_FALSE(error.where().file.empty()) << error.what();
    const std::string text = error.what();
    const size_t name = text.find("technique.toml");
    return name == std::string::npos ? text : text.substr(name);
  }
  return "no error";
}

std::string error_after(std::string_view from, std::string_view to) {
  TechniqueFolder folder;
  return error_of(folder, replaced(whole_manifest(), from, to));
}

}  // namespace umbrameter
