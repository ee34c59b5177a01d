// SPDX-License-Identifier: Apache-2.0
// Without these, a driver's complaint, a wrong device or a flipped depth range would go unnoticed.

#include "realtime/harness/draw.h"
#include "realtime/harness/objects.h"
#include "tests/gpu/gl_test.h"

#include <gmock/gmock.h>

#include <thread>

namespace umbrameter {
namespace {

using test::error_of;
using test::GlTest;
using ::testing::HasSubstr;

class ContextTest : public GlTest {};

TEST_F(ContextTest, OpensOpenGl45) {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(10 * major + minor, 45);
  EXPECT_FALSE(context().device().renderer.empty());
  EXPECT_GE(context().limits().max_texture_size, 16384);  // the least OpenGL 4.5 allows
  EXPECT_GE(context().limits().subpixel_bits, 4);
}

TEST_F(ContextTest, UsesZeroToOneDepth) {
  GLint depth_mode = 0, origin = 0;
  glGetIntegerv(GL_CLIP_DEPTH_MODE, &depth_mode);
  glGetIntegerv(GL_CLIP_ORIGIN, &origin);
  EXPECT_EQ(depth_mode, GL_ZERO_TO_ONE);
  EXPECT_EQ(origin, GL_LOWER_LEFT);
}

TEST_F(ContextTest, TheBestDeviceIsHardwareIfThereIsAny) {
  bool has_hardware = false;
  for (const GlDevice& device : list_gl_devices()) has_hardware = has_hardware || device.is_hardware;
  EXPECT_EQ(context().device().is_hardware, has_hardware);
}

TEST_F(ContextTest, ListingDevicesKeepsTheCurrentContext) {
  const GLuint before = make_empty_vertex_array().id();
  ASSERT_FALSE(list_gl_devices().empty());
  EXPECT_GT(make_empty_vertex_array().id(), 0u) << "first object " << before;
  check_gl_errors("after listing");
}

TEST_F(ContextTest, ADeviceIsChosenByIndexOrByPartOfItsNameInAnyCase) {
  const GlDevice& device = context().device();
  EXPECT_EQ(GlContext(std::to_string(device.index)).device().renderer, device.renderer);
  std::string upper = device.renderer.substr(0, 6);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_EQ(GlContext(upper).device().renderer, device.renderer);
}

TEST_F(ContextTest, SoftwareRenderingIsFoundByName) {
  for (const GlDevice& device : list_gl_devices()) {
    if (device.renderer.find("llvmpipe") == std::string::npos) continue;
    EXPECT_FALSE(GlContext("llvmpipe").device().is_hardware);
    return;
  }
  GTEST_SKIP() << "Mesa's llvmpipe is not installed (libgl1-mesa-dri)";
}

TEST_F(ContextTest, AnUnknownDeviceIsAnEnvironmentErrorThatListsWhatThereIs) {
  const std::string message = error_of(ErrorKind::environment, [] { GlContext("voodoo"); });
  EXPECT_THAT(message, HasSubstr("'voodoo'"));
  EXPECT_THAT(message, HasSubstr(context().device().renderer));
  EXPECT_THAT(message, HasSubstr("umbrameter doctor"));
  EXPECT_THAT(error_of(ErrorKind::environment, [] { GlContext("77"); }),
              HasSubstr("no device of that index"));
}

TEST_F(ContextTest, AWrongCallIsReportedOnceWithWhatWasDone) {
  EXPECT_NO_THROW(check_gl_errors("nothing"));
  glEnable(GL_TEXTURE_WIDTH);
  EXPECT_THAT(error_of(ErrorKind::internal, [] { check_gl_errors("pass 'blur'"); }),
              ::testing::AllOf(HasSubstr("pass 'blur'"), HasSubstr("GL_INVALID_ENUM")));
  EXPECT_NO_THROW(check_gl_errors("nothing"));
}

TEST_F(ContextTest, TwoContextsKeepTheirErrorsApart) {
  GlContext other;
  glEnable(GL_TEXTURE_WIDTH);
  context().make_current();
  EXPECT_NO_THROW(check_gl_errors("the first"));
  other.make_current();
  EXPECT_THROW(check_gl_errors("the second"), Error);
}

TEST_F(ContextTest, AContextMovesToAnotherThreadThatMakesItCurrent) {
  GlContext other;
  context().make_current();  // releases `other` from this thread
  GLuint id = 0;
  std::thread([&] {
    GlContext moved(std::move(other));  // dies on this thread, after the array
    moved.make_current();
    id = make_empty_vertex_array().id();
    glFinish();
  }).join();
  EXPECT_NE(id, 0u);
}

}  // namespace
}  // namespace umbrameter
