// SPDX-License-Identifier: Apache-2.0
#pragma once
// The window's loop: events into what is chosen, what came of it onto the screen.

#include "view/camera_path.h"
#include "view/file_watch.h"
#include "view/scene_worker.h"
#include "view/session.h"
#include "view/view.h"
#include "view/window.h"

#include <array>
#include <future>
#include <set>

namespace umbrameter {

/// What one asked to be saved, and the file; an empty name is chosen.
enum class Saved : uint8_t { picture, window, scene, preset, study, path };
struct SaveRequest {
  Saved what = Saved::picture;
  std::filesystem::path file;
};

class LiveView final : public WindowEvents {
 public:
  explicit LiveView(ViewSetup setup);
  /// Until the window is closed or the script is at its end.
  ViewReport run();

  void on_key(int key, int action, int mods) override;
  void on_button(int button, int action) override;
  void on_move(double x, double y) override;
  void on_scroll(double steps) override;
  void on_drop(const std::string& file) override;

 private:
  friend class ScriptRun;
  struct Pane {  // where a picture lies in the window
    float left = 0, top = 0, width = 0, height = 0;
  };

  void frame(double wait_s);
  void move_by_keys(double seconds);
  void follow_path(double seconds);
  void watch_files();
  void open_scene(const std::string& name);
  void take_scene();
  void show_scene(const LoadedScene& loaded);
  void repaint();
  void lay_out();
  void draw_panes();
  void draw_pane(const Pane& pane, PictureTexture& texture, const char* title, float from, float to);
  void draw_notes();
  void draw_panel();
  std::vector<SaveRequest> take_saves();
  void save(const SaveRequest& request, const Picture& window);
  std::filesystem::path free_name(std::string_view stem, std::string_view ending) const;
  void say(const std::string& note) { note_ = note, note_until_ = Clock::now() + std::chrono::seconds(4); }
  bool is_over_pictures() const;  // the pointer, as of the last move
  void start_recording_or_stop();
  ViewReport report() const;
  PaintInputs inputs_of(const Image& image) const;
  double frame_wait_s() const;

  ViewSetup setup_;
  ViewState state_;
  Window window_;
  std::future<void> closing_;  // of the session before; both after the window, which its threads wake
  std::unique_ptr<Session> session_;
  SceneWorker scenes_;
  std::string opening_;  // the scene that is being read
  FileWatch files_;
  PictureTexture test_texture_, truth_texture_, resource_texture_;
  Picture test_picture_, truth_picture_;
  std::string painted_;  // what the textures show
  double resource_min_ = 0.0, resource_max_ = 0.0;
  std::string resource_problem_;
  std::set<int> held_;
  std::optional<int> dragging_;
  bool drags_split_ = false;
  double last_x_ = 0.0, last_y_ = 0.0;
  double fly_speed_world_ = 1.0;  // a second
  bool has_panel_ = true, has_help_ = false;
  std::optional<size_t> only_section_;  // to be unfolded, the others folded
  Pane area_;                           // of the pictures
  std::vector<SaveRequest> saves_;
  std::vector<CameraKey> path_;
  bool is_recording_ = false;
  std::optional<double> playing_s_;
  Clock::time_point recording_since_{};
  std::string note_;
  Clock::time_point note_until_{};
  int switches_ = 0;
  double memory_first_mib_ = 0.0;
  double truth_s_ = 0.0;  // of the place below
  uint64_t truth_place_version_ = 0;
  std::vector<Pane> shown_;  // where whole pictures lie, also where only a part is drawn
};

/// Resident memory of this process.
double resident_mib();

}  // namespace umbrameter
