// SPDX-License-Identifier: Apache-2.0
#include "view/window.h"

#include "core/error.h"
#include "view/style.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>

namespace umbrameter {
namespace {

std::string glfw_problem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "GLFW does not say why" : text;
}

WindowEvents& events_of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
  ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, mods);
  const bool is_typed_elsewhere = ImGui::GetIO().WantTextInput && action != GLFW_RELEASE;
  if (!is_typed_elsewhere) events_of(window).on_key(key, action, mods);
}

void on_button(GLFWwindow* window, int button, int action, int mods) {
  ImGui_ImplGlfw_MouseButtonCallback(window, button, action, mods);
  if (ImGui::GetIO().WantCaptureMouse && action == GLFW_PRESS) return;
  // Where the pointer was then is what on_move said last; it may be elsewhere by now.
  events_of(window).on_button(button, action);
}

void on_move(GLFWwindow* window, double x, double y) {
  events_of(window).on_move(x, y);
}

void on_scroll(GLFWwindow* window, double x, double y) {
  ImGui_ImplGlfw_ScrollCallback(window, x, y);
  if (!ImGui::GetIO().WantCaptureMouse) events_of(window).on_scroll(y);
}

void on_drop(GLFWwindow* window, int count, const char** files) {
  if (count > 0) events_of(window).on_drop(files[0]);
}

GLFWwindow* open_window(int width_px, int height_px, const std::string& title) {
  if (glfwInit() == GLFW_FALSE)
    fail_environment("no window can be opened: " + glfw_problem(),
                     "a display is needed: DISPLAY names an X server; xvfb-run makes one");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  GLFWwindow* window = glfwCreateWindow(width_px, height_px, title.c_str(), nullptr, nullptr);
  if (window != nullptr) return window;
  const std::string problem = glfw_problem();
  glfwTerminate();
  fail_environment("no window with OpenGL 3.3 can be opened: " + problem, "install libgl1-mesa-dri");
}

/// Of the back buffer.
Picture read_pixels(GLFWwindow* window) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  const size_t row = 3 * static_cast<size_t>(width);
  std::vector<uint8_t> bottom_up(row * static_cast<size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.data());
  Picture picture{width, height, std::vector<uint8_t>(bottom_up.size()), 0.0};
  for (size_t y = 0; y < static_cast<size_t>(height); ++y) {
    const auto from = bottom_up.end() - static_cast<std::ptrdiff_t>((y + 1) * row);
    std::copy_n(from, row, picture.rgb.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  return picture;
}

}  // namespace

struct Window::Handles {
  GLFWwindow* window = nullptr;
};

Window::Window(int width_px, int height_px, const std::string& title, WindowEvents& events)
    : handles_(std::make_unique<Handles>()) {
  GLFWwindow* window = handles_->window = open_window(width_px, height_px, title);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window, &events);
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  float scale_x = 1.0f, scale_y = 1.0f;
  glfwGetWindowContentScale(window, &scale_x, &scale_y);
  set_style(std::max(scale_x, scale_y));
  ImGui_ImplGlfw_InitForOpenGL(window, true);  // before ours, which call its callbacks
  ImGui_ImplOpenGL3_Init("#version 330 core");
  glfwSetKeyCallback(window, on_key);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetCursorPosCallback(window, on_move);
  glfwSetScrollCallback(window, on_scroll);
  glfwSetDropCallback(window, on_drop);
  device_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(handles_->window);
  glfwTerminate();
}

void Window::wake() {
  glfwPostEmptyEvent();
}

bool Window::wants_to_close() const {
  return glfwWindowShouldClose(handles_->window) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(handles_->window, GLFW_TRUE);
}

void Window::begin_frame(double wait_s) {
  if (wait_s > 0.0) {
    glfwWaitEventsTimeout(wait_s);
  } else {
    glfwPollEvents();
  }
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::end_frame(Picture* shot) {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(handles_->window, &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (shot != nullptr) *shot = read_pixels(handles_->window);
  glfwSwapBuffers(handles_->window);
}

void Window::resize(int width_px, int height_px) {
  glfwSetWindowSize(handles_->window, width_px, height_px);
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(handles_->window, title.c_str());
}

void Window::send_key(int key, int action, int mods) {
  on_key(handles_->window, key, 0, action, mods);
}

void Window::send_button(int button, int action, double x, double y) {
  if (action == GLFW_PRESS) send_move(x, y);
  events_of(handles_->window).on_button(button, action);
}

void Window::send_move(double x, double y) {
  events_of(handles_->window).on_move(x, y);
}

void Window::send_scroll(double steps) {
  events_of(handles_->window).on_scroll(steps);
}

PictureTexture::~PictureTexture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void PictureTexture::set(const Picture& picture, bool is_smooth) {
  if (name_ == 0) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, is_smooth ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width_px, picture.height_px, 0, GL_RGB, GL_UNSIGNED_BYTE,
               picture.rgb.data());
  width_px_ = picture.width_px;
  height_px_ = picture.height_px;
}

void* PictureTexture::handle() const {
  return reinterpret_cast<void*>(static_cast<uintptr_t>(name_));
}

}  // namespace umbrameter
