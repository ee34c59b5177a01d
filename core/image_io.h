// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading and writing image files through OpenImageIO. Every write goes to a temporary name and is renamed.

#include "core/image.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// One part (subimage) of a file, on its display window.
struct ImagePart {
  std::string name;               // of the part; often empty
  Image image;                    // 0 where the file has no data
  std::vector<uint8_t> has_data;  // [height][width]: the data window covers the pixel
  int levels = 0;                 // 255 for 8 bits, 65535 for 16; 0 for floats
  std::string format;             // OpenImageIO's name: "openexr", "png", "jpeg"
};

/// Reads all parts of any file OpenImageIO knows into float planes named by the file's channels. Colours come as they are
/// stored: never multiplied by alpha. Whole numbers of 32 bits keep their value. String attributes that start with
/// "umbrameter:" come back as metadata without that prefix. Error{input} for missing, truncated, empty or deep images and
/// those larger than 16384 x 16384.
std::vector<ImagePart> read_image_parts(const std::filesystem::path& path);

/// The first part; Error{input} also where its data do not fill the display window.
Image read_image(const std::filesystem::path& path);
/// The same of a file's bytes; `name` ends like the file would (".png") and stands in messages.
Image read_image(std::span<const uint8_t> bytes, const std::string& name);

/// Writes one EXR, 32-bit float, zip-compressed, channels by name, metadata as "umbrameter:<key>" strings.
/// Error{input} when the place cannot be written.
void write_exr(const std::filesystem::path& path, const Image& image);

/// Writes an 8-bit RGB PNG from rgb[height][width][3], row 0 on top.
void write_png(const std::filesystem::path& path, int width, int height, std::span<const uint8_t> rgb);

/// The same PNG as bytes, for pages that carry their pictures inside.
std::vector<uint8_t> encode_png(int width, int height, std::span<const uint8_t> rgb);

}  // namespace umbrameter
