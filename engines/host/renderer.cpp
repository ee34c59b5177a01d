// SPDX-License-Identifier: Apache-2.0
// The Renderer over engines' folders: keeps adapters and scene folders.

#include "core/clock.h"
#include "core/files.h"
#include "engines/engines.h"
#include "engines/host/adapter.h"
#include "engines/host/pictures.h"
#include "engines/host/placeholders.h"
#include "engines/host/scene_folders.h"
#include "scenes/instances.h"

#include <fmt/format.h>

#include <map>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

/// An adapter that did not start so often in a row is not started again.
constexpr int kMostFailedStarts = 3;

/// Frames that are timed with one picture: warm-up, and as many as most plans want.
constexpr int kFramesAtOnce = 25;
constexpr double kTimedSeconds = 3.0;

constexpr const char* kIntegrated =
    "the engine integrates the light: compared as irradiance ratio S, not as visibility V";

/// What stays of an engine between two pictures.
struct OpenEngine {
  Engine engine;
  fs::path work_folder;
  std::unique_ptr<Adapter> adapter;
  int failed_starts = 0;
};

/// Files and what the engine said about them.
struct Answered {
  EngineAnswer answer;
  EngineReady ready;
};

/// Letters, digits, '.', '_' and '-': a scene's name as a part of a path.
std::string plain_name(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                         c == '_' || c == '-' || c == '.';
    plain += is_kept ? c : '-';
  }
  const size_t first = plain.find_first_not_of('.');
  return first == std::string::npos ? "unnamed" : plain.substr(first);
}

PlaceholderValues values_of(const Scene& scene, const RenderRequest& request) {
  PlaceholderValues values = {{"name", plain_name(scene.name)},
                              {"width", std::to_string(request.width_px)},
                              {"height", std::to_string(request.height_px)},
                              {"seed", std::to_string(request.seed)}};
  for (const auto& [name, value] : request.parameters) values[name] = to_text(value);
  return values;
}

/// Finished pictures: parameters choose among them, and none lies outside of the engine's folder.
EngineAnswer find_pictures(const Engine& engine, const PlaceholderValues& values) {
  EngineAnswer answer;
  const fs::path root = fs::weakly_canonical(engine.folder);
  for (const auto& [key, text] : engine.files) {
    const fs::path file = fs::weakly_canonical(engine.folder / fill_placeholders(text, values));
    const fs::path inside = file.lexically_relative(root);
    if (inside.empty() || *inside.begin() == "..")
      fail_input(fmt::format("'{}' lies outside of the engine's folder", file.string()));
    if (!fs::is_regular_file(file)) fail_input(fmt::format("there is no picture '{}'", file.string()));
    answer.files[key == "picture" ? "visibility" : key] = file;
  }
  return answer;
}

void require_support(const Engine& engine, const Scene& scene) {
  const Light& light = scene.light();
  const uint64_t holes = count_shown_cutouts(scene);
  if (holes > 0 && engine.form != EngineForm::pictures) {
    fail_input(
        fmt::format("engine '{}' gets no cut-outs: {} of {} triangles have holes, which scene.obj does not",
                    engine.id, holes, count_shown_triangles(scene)));
  }
  if (engine.supports(light.type)) return;
  std::string supported;
  for (const auto& [type, text] : engine.lights)
    supported += fmt::format("{}{}", supported.empty() ? "" : ", ", to_text(type));
  fail_input(fmt::format("engine '{}' does not support {} lights", engine.id, to_text(light.type)), {},
             fmt::format("it supports {}", supported));
}

class EngineRenderer final : public Renderer {
 public:
  explicit EngineRenderer(const EngineSettings& settings)
      : settings_(settings), scenes_(made(settings.work_folder / "scenes")) {}

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    return draw(scene, request, 0, progress).frame;
  }

  /// An engine's frames are timed one after another, a few at once: it does not keep pictures in turn with others.
  PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    Drawn drawn = draw(scene, request, kFramesAtOnce, progress);
    if (drawn.frame_ms.empty()) return {std::move(drawn.frame), {}, {}, {}};
    const auto time_frame = [this, &scene, request, left = std::move(drawn.frame_ms)]() mutable {
      if (left.empty()) {
        SilentProgress silent;
        left = draw(scene, request, kFramesAtOnce, silent).frame_ms;
      }
      if (left.empty()) fail_environment("the engine has no more times");
      const double frame_ms = left.front();
      left.erase(left.begin());
      return std::vector<double>{frame_ms};
    };
    return {std::move(drawn.frame), time_frame, {"frame"}, std::move(drawn.timer)};
  }

 private:
  struct Drawn {
    Frame frame;
    std::vector<double> frame_ms;
    std::string timer;
  };

  Drawn draw(const Scene& scene, const RenderRequest& request, int timed_frames, Progress& progress) {
    const Clock::time_point start = Clock::now();
    OpenEngine& open = opened(request.technique);
    require_support(open.engine, scene);
    const fs::path out = made(settings_.work_folder / fmt::format("out-{}", ++requests_));
    Drawn drawn;
    Frame& frame = drawn.frame;
    try {
      progress.begin(open.engine.id, 1);
      const Answered answered = answer(open, scene, request, out, timed_frames, progress);
      frame.image = read_engine_picture(answered.answer.files, request.width_px, request.height_px);
      frame.warnings = answered.answer.warnings;
      if (open.engine.quantity == EngineQuantity::irradiance) {
        frame.image.metadata["quantity"] = to_text(open.engine.quantity);
        frame.warnings.emplace_back(kIntegrated);
      }
      frame.memory_bytes = answered.answer.memory_bytes;
      frame.device = answered.ready.device.empty()
                         ? answered.ready.version
                         : fmt::format("{}, {}", answered.ready.version, answered.ready.device);
      frame.is_software = answered.ready.is_software;
      drawn.frame_ms = answered.answer.frame_ms;
      drawn.timer = answered.answer.timer;
      progress.end();
    } catch (const Error& error) {
      fs::remove_all(out);
      if (error.kind() != ErrorKind::input) open.adapter.reset();  // whatever state it is in
      throw Error(error.kind(), fmt::format("engine '{}': {}", open.engine.id, error.what()));
    }
    fs::remove_all(out);
    frame.parameters = request.parameters;
    frame.wall_time_s = seconds_since(start);
    return drawn;
  }

  static fs::path made(const fs::path& folder) {
    create_folder(folder);
    return folder;
  }

  OpenEngine& opened(const std::string& id_or_path) {
    if (const auto known = engines_.find(id_or_path); known != engines_.end()) return known->second;
    std::optional<Engine> engine = find_engine(id_or_path, settings_.places);
    if (!engine) fail_input(fmt::format("there is no engine '{}'", id_or_path));
    OpenEngine open{std::move(*engine), {}, {}};
    require_installed(open.engine);
    open.work_folder = made(settings_.work_folder / fmt::format("engine-{}", engines_.size() + 1));
    return engines_.emplace(id_or_path, std::move(open)).first->second;
  }

  Answered answer(OpenEngine& open, const Scene& scene, const RenderRequest& request, const fs::path& out,
                  int timed_frames, Progress& progress) {
    if (open.engine.form == EngineForm::pictures)
      return {find_pictures(open.engine, values_of(scene, request)), {open.engine.title, {}, false}};
    const EngineRequest question{requests_,    scenes_.folder_of(scene, request.width_px, request.height_px),
                                 out,          &request,
                                 timed_frames, kTimedSeconds};
    if (open.engine.form == EngineForm::command)
      return {run_command(open, scene, question, progress), {open.engine.title, {}, false}};
    if (!open.adapter) start(open, progress);
    return {open.adapter->ask(question, progress), open.adapter->ready()};
  }

  void start(OpenEngine& open, Progress& progress) {
    if (open.failed_starts >= kMostFailedStarts)
      fail_environment(fmt::format("the adapter did not start {} times in a row and is not tried again",
                                   open.failed_starts));
    ++open.failed_starts;
    open.adapter = std::make_unique<Adapter>(open.engine, open.work_folder, progress);
    open.failed_starts = 0;
  }

  static EngineAnswer run_command(const OpenEngine& open, const Scene& scene, const EngineRequest& question,
                                  Progress& progress) {
    const Engine& engine = open.engine;
    PlaceholderValues values = values_of(scene, *question.request);
    values["scene"] = question.scene.string();
    EngineFiles files = {{"visibility", question.out / "visibility.exr"}};
    for (const char* what : {"lit", "unlit", "surfaces"})
      files[what] = question.out / fmt::format("{}.exr", what);
    for (const auto& [what, file] : files) values[what == "visibility" ? "out" : what] = file.string();
    std::vector<std::string> arguments;
    for (const std::string& argument : engine.command)
      arguments.push_back(fill_placeholders(argument, values));
    ForeignProcess process(start_of(engine, arguments, open.work_folder));
    const int code = process.wait(engine.limits.picture_s, progress);
    const std::string words = process.last_words();
    if (code != 0) {
      fail_environment(fmt::format("'{}' ended with exit code {}{}", engine.command.front(), code,
                                   words.empty() ? "" : "; its last words: " + words));
    }
    EngineAnswer answer;
    for (const auto& [what, file] : files) {
      if (fs::is_regular_file(file) && !fs::is_symlink(file)) answer.files[what] = file;
    }
    return answer;
  }

  EngineSettings settings_;
  SceneFolders scenes_;
  std::map<std::string, OpenEngine> engines_;
  uint64_t requests_ = 0;
};

}  // namespace

std::unique_ptr<Renderer> make_engine_renderer(const EngineSettings& settings) {
  return std::make_unique<EngineRenderer>(settings);
}

EngineCheck check_engine(const Engine& engine, const fs::path& work_folder) {
  require_installed(engine);
  if (engine.form != EngineForm::adapter) return {engine.title, {}};
  SilentProgress progress;
  const Adapter adapter(engine, work_folder, progress);
  return {adapter.ready().version, adapter.ready().device};
}

}  // namespace umbrameter
