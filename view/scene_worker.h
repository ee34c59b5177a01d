// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes read from their files on a thread of their own: large ones take seconds, in which the window goes on.

#include "scenes/scene.h"
#include "view/latest_worker.h"

#include <functional>
#include <memory>
#include <string>

namespace umbrameter {

/// `scene` as it was asked for; absent with `problem` for one that cannot be loaded.
struct LoadedScene {
  std::string name;
  std::shared_ptr<const Scene> scene;
  std::string problem;
};

using SceneWorker = LatestWorker<std::string, LoadedScene>;

/// What a SceneWorker opens. `load` throws Error{input} for what is no scene.
inline SceneWorker::Work open_loading(const std::function<Scene(const std::string&)>& load) {
  return [load](const std::string& name, SceneWorker::Desk& desk) {
    LoadedScene loaded{name, nullptr, {}};
    if (auto failure = guarded([&] { loaded.scene = std::make_shared<const Scene>(load(name)); }))
      loaded.problem = failure->message;
    desk.publish(std::move(loaded));
  };
}

}  // namespace umbrameter
