// SPDX-License-Identifier: Apache-2.0
#include "core/image_io.h"

#include "core/error.h"
#include "core/file_hint.h"
#include "core/files.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace umbrameter {

namespace {

constexpr int kMaxSide = 16384;
constexpr std::string_view kMetadataPrefix = "umbrameter:";

void require_usable(const OIIO::ImageSpec& spec, const std::string& file) {
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) {
    fail_input(
        fmt::format("the image is empty ({}x{}, {} channels)", spec.width, spec.height, spec.nchannels),
        {file});
  }
  if (spec.width <= kMaxSide && spec.height <= kMaxSide) return;
  fail_input(
      fmt::format("the image is {}x{}, larger than {}x{}", spec.width, spec.height, kMaxSide, kMaxSide),
      {file});
}

void read_metadata(const OIIO::ImageSpec& spec, Image& image) {
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (!name.starts_with(kMetadataPrefix)) continue;
    image.metadata[name.substr(kMetadataPrefix.size())] = attribute.get_string();
  }
}

/// Channel-interleaved rows, as OpenImageIO wants them.
std::vector<float> interleave(const Image& image) {
  std::vector<float> pixels(image.pixel_count() * image.planes.size());
  size_t channel = 0;
  for (const auto& [name, plane] : image.planes) {
    UMBRAMETER_ASSERT(plane.size() == image.pixel_count(), "channel '{}' has {} values", name, plane.size());
    for (size_t i = 0; i < plane.size(); ++i) pixels[i * image.planes.size() + channel] = plane[i];
    ++channel;
  }
  return pixels;
}

/// Opens `file` for `spec`, writes, closes; returns OpenImageIO's complaint, empty when it worked.
std::string write_pixels(OIIO::ImageOutput& output, const std::string& file, const OIIO::ImageSpec& spec,
                         OIIO::TypeDesc type, const void* pixels) {
  if (!output.open(file, spec)) return output.geterror();
  const bool written = output.write_image(type, pixels);
  const bool closed = output.close();
  if (written && closed) return {};
  const std::string problem = output.geterror();
  return problem.empty() ? "unknown error" : problem;
}

Image read_opened(const std::unique_ptr<OIIO::ImageInput>& input, const std::string& file) {
  if (!input) fail_input(fmt::format("not a readable image: {}", OIIO::geterror()), {file});
  const OIIO::ImageSpec spec = input->spec();
  require_usable(spec, file);
  const auto channel_count = static_cast<size_t>(spec.nchannels);
  Image image(spec.width, spec.height);
  std::vector<float> pixels(image.pixel_count() * channel_count);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())) {
    fail_input(fmt::format("the image is damaged or cut off: {}", input->geterror()), {file});
  }
  for (size_t c = 0; c < channel_count; ++c) {
    const std::span<float> plane = image.add_plane(spec.channelnames[c]);
    for (size_t i = 0; i < plane.size(); ++i) plane[i] = pixels[i * channel_count + c];
  }
  read_metadata(spec, image);
  return image;
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
  const std::string file = path.string();
  if (!std::filesystem::exists(path)) fail_input("the file does not exist", {file}, hint_for_missing(path));
  return read_opened(OIIO::ImageInput::open(file), file);
}

Image read_image(std::span<const uint8_t> bytes, const std::string& name) {
  OIIO::Filesystem::IOMemReader reader(const_cast<uint8_t*>(bytes.data()), bytes.size());
  return read_opened(OIIO::ImageInput::open(name, nullptr, &reader), name);
}

void write_exr(const std::filesystem::path& path, const Image& image) {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.planes.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const auto& [name, plane] : image.planes) spec.channelnames.push_back(name);
  for (const auto& [key, value] : image.metadata) spec.attribute(std::string(kMetadataPrefix) + key, value);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // else the time is added, and equal images are not equal files
  const std::vector<float> pixels = interleave(image);
  const std::filesystem::path temporary = temporary_name(path);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("exr");
  UMBRAMETER_ASSERT(output != nullptr, "OpenImageIO has no EXR writer: {}", OIIO::geterror());
  const std::string problem =
      write_pixels(*output, temporary.string(), spec, OIIO::TypeDesc::FLOAT, pixels.data());
  if (!problem.empty()) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail_input(fmt::format("cannot be written: {}", problem), {path.string()},
               "does the folder exist, and is there room and permission?");
  }
  rename_into_place(temporary, path);
}

std::vector<uint8_t> encode_png(int width, int height, std::span<const uint8_t> rgb) {
  const size_t expected = static_cast<size_t>(width) * static_cast<size_t>(height) * 3;
  UMBRAMETER_ASSERT(rgb.size() == expected, "{} bytes for a {}x{} picture", rgb.size(), width, height);
  const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
  UMBRAMETER_ASSERT(output != nullptr, "OpenImageIO has no PNG writer: {}", OIIO::geterror());
  std::vector<uint8_t> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  output->set_ioproxy(&memory);
  const std::string problem = write_pixels(*output, "memory.png", spec, OIIO::TypeDesc::UINT8, rgb.data());
  UMBRAMETER_ASSERT(problem.empty(), "PNG encoding failed: {}", problem);
  return bytes;
}

void write_png(const std::filesystem::path& path, int width, int height, std::span<const uint8_t> rgb) {
  const std::vector<uint8_t> bytes = encode_png(width, height, rgb);
  write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace umbrameter
