// SPDX-License-Identifier: Apache-2.0
#pragma once
// A GLFW window with an OpenGL context of its own and Dear ImGui in it. It only shows pictures; techniques are drawn elsewhere.

#include "results/pictures/pictures.h"

#include <cstdint>
#include <memory>
#include <string>

struct GLFWwindow;

namespace umbrameter {

/// What happens in the window, beside what ImGui takes for itself. Keys and actions are GLFW's.
class WindowEvents {
 public:
  virtual ~WindowEvents() = default;
  virtual void on_key(int key, int action, int mods) = 0;
  virtual void on_button(int button, int action) = 0;
  virtual void on_move(double x, double y) = 0;
  virtual void on_scroll(double steps) = 0;
  virtual void on_drop(const std::string& file) = 0;  // let go over the window
};

class Window {
 public:
  /// Error{environment} without a display or OpenGL 3.3. `events` must outlive the window.
  Window(int width_px, int height_px, const std::string& title, WindowEvents& events);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Ends a wait in begin_frame(); from any thread.
  static void wake();
  bool wants_to_close() const;
  void close();
  /// Handles what has happened, waiting up to `wait_s` for something to, and begins a frame of ImGui's.
  void begin_frame(double wait_s);
  /// Draws the frame and shows it; `shot`, if given, becomes what is shown.
  void end_frame(Picture* shot = nullptr);
  void resize(int width_px, int height_px);
  void set_title(const std::string& title);
  /// The callbacks that GLFW calls, for scripts.
  void send_key(int key, int action, int mods);
  void send_button(int button, int action, double x, double y);
  void send_move(double x, double y);
  void send_scroll(double steps);
  const std::string& device() const { return device_; }

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  std::string device_;
};

/// A picture as a texture of the window's context.
class PictureTexture {
 public:
  PictureTexture() = default;
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  /// `is_smooth`: linear when it is shown larger than it is.
  void set(const Picture& picture, bool is_smooth);
  /// As ImGui::Image() takes it; null before set().
  void* handle() const;
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

 private:
  uint32_t name_ = 0;
  int width_px_ = 0, height_px_ = 0;
};

}  // namespace umbrameter
