// SPDX-License-Identifier: Apache-2.0
#include "tests/support/engine_folder.h"

#include "core/files.h"
#include "tests/support/source_dir.h"

#include <fmt/format.h>

namespace umbrameter {

EngineFolder::EngineFolder() {
  std::filesystem::create_directories(path());
  std::filesystem::create_directories(work());
  write("engine.toml", test_engine_manifest());
}

EngineFolder& EngineFolder::write(const std::string& name, std::string_view text) {
  const std::filesystem::path file = path() / name;
  std::filesystem::create_directories(file.parent_path());
  write_file_atomically(file, text);
  return *this;
}

std::string engine_manifest_with(const std::string& form) {
  return "schema = 1\nid = \"tried\"\ntitle = \"An engine of a test\"\nsummary = \"Draws "
         "nothing.\"\nquantity = \"visibility\"\n" +
         form + R"(
[lights]
rect = "a point"
sun = "a direction"

[[parameter]]
name = "misbehave"
type = "choice"
choices = ["no", "hang", "crash", "signal", "garbage", "close", "memory", "long_line", "chatter", "error", "other_id",
           "escape", "link", "missing", "size", "nan", "half", "nothing", "pair", "rows", "no_times"]
default = "no"
doc = "what goes wrong"

[[parameter]]
name = "shadow.grey"
type = "real"
default = 0.5
min = 0.0
max = 1.0
doc = "visibility everywhere"
)";
}

std::string test_engine_manifest() {
  return engine_manifest_with(
      fmt::format("adapter = [\"python3\", \"{}/tests/engine/adapter.py\"]\n"
                  "seconds_to_start = 20\nseconds_per_picture = 4\nmemory_mib = 300\n",
                  source_dir().string()));
}

}  // namespace umbrameter
