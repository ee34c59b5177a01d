// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scene documents for tests: a valid one whose tables can be replaced one by one.

#include "core/error.h"
#include "scenes/load_scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace umbrameter {

struct SceneText {
  std::string top = {};
  std::string camera = "eye = [0, 2, 5]\nat = [0, 0, 0]";
  std::string mesh = "shape = \"plane\"\nsize = [4, 4]";
  std::string light = "type = \"rect\"\ncenter = [0, 4, 0]\ndirection = [0, -1, 0]\nsize = [1, 1]";

  /// The camera's table starts in line 1 when `top` is empty, the mesh's after it, the light's last.
  std::string document() const {
    return top + "[camera]\n" + camera + "\n[[mesh]]\n" + mesh + "\n[[light]]\n" + light + "\n";
  }
  Scene parse(const std::filesystem::path& file = "x.toml", const SceneSearch& search = {}) const {
    return parse_scene(document(), file, search);
  }
};

/// The message of the Error{input} that `action` throws.
inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

}  // namespace umbrameter
