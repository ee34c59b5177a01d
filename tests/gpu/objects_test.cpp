// SPDX-License-Identifier: Apache-2.0
// Without these, a format could store something else than its name says, or a row be read back upside down.

#include "realtime/harness/objects.h"
#include "realtime/harness/draw.h"
#include "realtime/harness/readback.h"
#include "tests/gpu/gl_test.h"

#include <gmock/gmock.h>

#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace umbrameter {
namespace {

using test::error_of;
using test::GlTest;
using ::testing::AllOf;
using ::testing::HasSubstr;

class ObjectsTest : public GlTest {};

std::vector<std::string> channel_names(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("c" + std::to_string(i));
  return names;
}

TEST_F(ObjectsTest, EveryFormatCanBeDrawnToClearedAndReadBack) {
  for (const TextureFormat& format : texture_formats()) {
    SCOPED_TRACE(format.name);
    const Texture texture(format, 5, 3, "t");
    const Texture* color = &texture;
    const Framebuffer framebuffer(std::span(&color, format.is_depth ? 0u : 1u),
                                  format.is_depth ? &texture : nullptr);
    EXPECT_EQ(framebuffer.width(), 5);
    EXPECT_EQ(texture.bytes(), 15u * static_cast<size_t>(format.bytes_per_texel));
    // Values that every format holds exactly: 8-bit ones know only k/255, so 0 and 1.
    const std::array<double, 4> value = {1.0, 0.0, 1.0, 1.0};
    clear_texture(texture, value);
    Image image(5, 3);
    read_texture(texture, channel_names(format.components), image);
    for (int c = 0; c < format.components; ++c) {
      const std::span<const float> plane = std::as_const(image).plane("c" + std::to_string(c));
      EXPECT_THAT(std::vector<float>(plane.begin(), plane.end()),
                  ::testing::Each(static_cast<float>(value[static_cast<size_t>(c)])));
    }
    check_gl_errors("format");
  }
}

TEST_F(ObjectsTest, TheGpuHasTheBitsTheFormatTableClaims) {
  for (const TextureFormat& format : texture_formats()) {
    const Texture texture(format, 1, 1);
    int bits = 0;
    for (const GLenum channel : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                 GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE}) {
      GLint size = 0;
      glGetTextureLevelParameteriv(texture.id(), 0, channel, &size);
      bits += size;
    }
    const std::map<std::string_view, int> padded = {{"depth24", 24}, {"depth32f_stencil8", 32 + 8}};
    const auto known = padded.find(format.name);
    EXPECT_EQ(bits, known != padded.end() ? known->second : 8 * format.bytes_per_texel) << format.name;
  }
}

TEST_F(ObjectsTest, AnUnknownFormatIsAnInputErrorWithAHint) {
  const std::string message = error_of(ErrorKind::input, [] {
    find_texture_format("rg32", {"technique.toml", 7, 10});
  });
  EXPECT_THAT(message, AllOf(HasSubstr("technique.toml:7:10"), HasSubstr("'rg32'"), HasSubstr("'rg32f'")));
}

TEST_F(ObjectsTest, ASizeTheDeviceCannotTakeIsAnInputErrorThatNamesTheLimit) {
  const TextureFormat& format = find_texture_format("r8");
  const int limit = context().limits().max_texture_size;
  for (const int side : {0, -4, limit + 1}) {
    const std::string message = error_of(ErrorKind::input, [&] {
      Texture(format, side, 8, "moments", {"technique.toml", 3, 1});
    });
    EXPECT_THAT(message, AllOf(HasSubstr("technique.toml:3:1"), HasSubstr("'moments'"),
                               HasSubstr(std::to_string(side)), HasSubstr(std::to_string(limit))));
  }
}

TEST_F(ObjectsTest, ReadbackPutsGlsLastRowOnTop) {
  const Texture texture(find_texture_format("rg32f"), 2, 3);
  // GL row 0 is the bottom one.
  const std::array<float, 12> texels = {0, 10, 1, 11, 2, 12, 3, 13, 4, 14, 5, 15};
  glTextureSubImage2D(texture.id(), 0, 0, 0, 2, 3, GL_RG, GL_FLOAT, texels.data());
  Image image(2, 3);
  read_texture(texture, std::array<std::string, 2>{"", "second"}, image);
  EXPECT_FALSE(image.has(""));
  const std::span<const float> second = std::as_const(image).plane("second");
  EXPECT_THAT(std::vector<float>(second.begin(), second.end()),
              ::testing::ElementsAre(14, 15, 12, 13, 10, 11));
}

TEST_F(ObjectsTest, IdentifiersReadBackExactlyAndNoneIsMinusOne) {
  const Texture texture(find_texture_format("r32ui"), 2, 1);
  const std::array<GLuint, 2> texels = {(1u << 24) - 1, 0xffffffffu};
  glTextureSubImage2D(texture.id(), 0, 0, 0, 2, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, texels.data());
  Image image(2, 1);
  read_texture(texture, std::array<std::string, 1>{"id"}, image);
  EXPECT_EQ(image.plane("id")[0], 16777215.0f);
  EXPECT_EQ(image.plane("id")[1], -1.0f);
}

TEST_F(ObjectsTest, MovingLeavesNothingBehind) {
  Texture first(find_texture_format("r8"), 4, 4);
  const GLuint id = first.id();
  Texture second = std::move(first);
  EXPECT_EQ(second.id(), id);
  second = Texture();
  EXPECT_FALSE(glIsTexture(id));
}

TEST_F(ObjectsTest, BuffersHoldWhatTheyWereGivenAndZeroOtherwise) {
  const std::array<float, 4> data = {1, 2, 3, 4};
  Buffer buffer(sizeof data, nullptr, true);
  std::array<float, 4> back{9, 9, 9, 9};
  glGetNamedBufferSubData(buffer.id(), 0, sizeof back, back.data());
  EXPECT_THAT(back, ::testing::Each(0.0f));
  buffer.update(data.data() + 1, 2 * sizeof(float), sizeof(float));
  glGetNamedBufferSubData(buffer.id(), 0, sizeof back, back.data());
  EXPECT_THAT(back, ::testing::ElementsAre(0, 2, 3, 0));
  EXPECT_THROW(buffer.update(data.data(), sizeof data, 4), Error);
}

TEST_F(ObjectsTest, SamplersCarryTheirSettings) {
  const Sampler sampler(
      {.filter = TextureFilter::linear, .border = {0.25f, 0.5f, 0.75f, 1.0f}, .compare = true});
  GLint filter = 0, wrap = 0, mode = 0, function = 0;
  glm::vec4 border(0.0f);
  glGetSamplerParameteriv(sampler.id(), GL_TEXTURE_MAG_FILTER, &filter);
  glGetSamplerParameteriv(sampler.id(), GL_TEXTURE_WRAP_T, &wrap);
  glGetSamplerParameteriv(sampler.id(), GL_TEXTURE_COMPARE_MODE, &mode);
  glGetSamplerParameteriv(sampler.id(), GL_TEXTURE_COMPARE_FUNC, &function);
  glGetSamplerParameterfv(sampler.id(), GL_TEXTURE_BORDER_COLOR, &border.x);
  EXPECT_EQ(filter, GL_LINEAR);
  EXPECT_EQ(wrap, GL_CLAMP_TO_BORDER);
  EXPECT_EQ(mode, GL_COMPARE_REF_TO_TEXTURE);
  EXPECT_EQ(function, GL_GEQUAL);
  EXPECT_EQ(border, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
}

}  // namespace
}  // namespace umbrameter
