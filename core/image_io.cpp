// SPDX-License-Identifier: Apache-2.0
#include "core/image_io.h"

#include "core/error.h"
#include "core/file_hint.h"
#include "core/files.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr int kMaxSide = 16384;
constexpr std::string_view kMetadataPrefix = "umbrameter:";

void require_usable(const OIIO::ImageSpec& spec, const std::string& file) {
  if (spec.deep) fail_input("the image is deep: it has several samples per pixel", {file}, "flatten it");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) {
    fail_input(
        fmt::format("the image is empty ({}x{}, {} channels)", spec.width, spec.height, spec.nchannels),
        {file});
  }
  const int width = std::max(spec.width, spec.full_width), height = std::max(spec.height, spec.full_height);
  if (width <= kMaxSide && height <= kMaxSide) return;
  fail_input(fmt::format("the image is {}x{}, larger than {}x{}", width, height, kMaxSide, kMaxSide), {file});
}

void read_metadata(const OIIO::ImageSpec& spec, Image& image) {
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (!name.starts_with(kMetadataPrefix)) continue;
    image.metadata[name.substr(kMetadataPrefix.size())] = attribute.get_string();
  }
}

int levels_of(const OIIO::ImageSpec& spec) {
  if (spec.format.is_floating_point() || spec.format.basesize() > 2) return 0;
  const int bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(8 * spec.format.basesize()));
  return (1 << bits) - 1;
}

/// OpenImageIO makes whole numbers of 32 bits shares of the largest one.
float stored_value(const OIIO::ImageSpec& spec, int channel, float value) {
  if (spec.channelformat(channel) != OIIO::TypeDesc::UINT32) return value;
  return static_cast<float>(std::round(static_cast<double>(value) * std::numeric_limits<uint32_t>::max()));
}

/// Places the data window's `pixels` in the display window.
void place(const OIIO::ImageSpec& spec, std::span<const float> pixels, ImagePart& part) {
  const auto channels = static_cast<size_t>(spec.nchannels);
  std::vector<std::span<float>> planes;
  for (const std::string& name : spec.channelnames) planes.push_back(part.image.add_plane(name));
  for (int y = 0; y < spec.height; ++y) {
    const int to_y = spec.y + y - spec.full_y;
    if (to_y < 0 || to_y >= part.image.height) continue;
    for (int x = 0; x < spec.width; ++x) {
      const int to_x = spec.x + x - spec.full_x;
      if (to_x < 0 || to_x >= part.image.width) continue;
      const size_t from = static_cast<size_t>(y) * static_cast<size_t>(spec.width) + static_cast<size_t>(x);
      const size_t to =
          static_cast<size_t>(to_y) * static_cast<size_t>(part.image.width) + static_cast<size_t>(to_x);
      part.has_data[to] = 1;
      for (size_t c = 0; c < channels; ++c)
        planes[c][to] = stored_value(spec, static_cast<int>(c), pixels[from * channels + c]);
    }
  }
}

ImagePart read_part(OIIO::ImageInput& input, int index, const std::string& file) {
  const OIIO::ImageSpec spec = input.spec(index);
  require_usable(spec, file);
  ImagePart part;
  part.name = spec.get_string_attribute("oiio:subimagename");
  part.format = input.format_name();
  part.levels = levels_of(spec);
  part.image = Image(spec.full_width, spec.full_height);
  part.has_data.assign(part.image.pixel_count(), 0);
  std::vector<float> pixels(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                            static_cast<size_t>(spec.nchannels));
  if (!input.read_image(index, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())) {
    fail_input(fmt::format("the image is damaged or cut off: {}", input.geterror()), {file});
  }
  place(spec, pixels, part);
  read_metadata(spec, part.image);
  return part;
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

/// All parts of what was opened as `file`.
std::vector<ImagePart> read_opened(const std::unique_ptr<OIIO::ImageInput>& input, const std::string& file) {
  if (!input) fail_input(fmt::format("not a readable image: {}", OIIO::geterror()), {file});
  std::vector<ImagePart> parts;
  for (int index = 0; input->seek_subimage(index, 0); ++index)
    parts.push_back(read_part(*input, index, file));
  static_cast<void>(input->geterror());  // that there is no further part
  return parts;
}

/// Colours as they are stored, not multiplied by alpha.
OIIO::ImageSpec as_stored() {
  OIIO::ImageSpec spec;
  spec.attribute("oiio:UnassociatedAlpha", 1);
  return spec;
}

Image whole_first(std::vector<ImagePart> parts, const std::string& file) {
  const ImagePart& first = parts.front();
  if (std::ranges::find(first.has_data, 0) != first.has_data.end())
    fail_input("the image's data do not fill its display window", {file});
  return std::move(parts.front().image);
}

}  // namespace

std::vector<ImagePart> read_image_parts(const std::filesystem::path& path) {
  const std::string file = path.string();
  if (!std::filesystem::exists(path)) fail_input("the file does not exist", {file}, hint_for_missing(path));
  const OIIO::ImageSpec config = as_stored();
  return read_opened(OIIO::ImageInput::open(file, &config), file);
}

Image read_image(const std::filesystem::path& path) {
  return whole_first(read_image_parts(path), path.string());
}

Image read_image(std::span<const uint8_t> bytes, const std::string& name) {
  OIIO::Filesystem::IOMemReader reader(const_cast<uint8_t*>(bytes.data()), bytes.size());
  OIIO::Filesystem::IOProxy* proxy = &reader;
  OIIO::ImageSpec config = as_stored();
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR,
                   &proxy);  // beside a config, open()'s own argument is not heard
  return whole_first(read_opened(OIIO::ImageInput::open(name, &config), name), name);
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
