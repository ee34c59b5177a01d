// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files of other renderers: which part, layer and channels are the picture, and which are its surfaces. One reader for the
// picture, its baseline, pairs and surfaces; everything is placed on the display window. Names: lab/pictures/engine_channels.h.
// Not here: transfer, visibility (lab/pictures/engine_image.h) and alignment (lab/pictures/engine_surfaces.h).

#include "core/image_io.h"
#include "lab/pictures/engine_channels.h"

#include <string>
#include <vector>

namespace umbrameter {

/// What of a file is meant; empty: whatever is unambiguous.
struct PictureChoice {
  std::string part;     // number from 1, or name
  std::string channel;  // a channel or a layer
};

/// Channels of one part that are a picture: one, or R, G and B.
struct PictureChannels {
  ImagePart part;
  std::vector<std::string> channels;
  std::vector<std::string> notes;  // what was chosen where others were there, and what the format costs
};

/// The picture of `file`: a channel called visibility, else the one layer of colours or of grey; `choice` settles the rest.
/// Error{input} naming parts, layers and channels when there is none or more than one.
PictureChannels read_picture(const std::filesystem::path& file, const PictureChoice& choice = {});

/// Surfaces under our own names (core/renderer.h): position.x/y/z, normal.x/y/z, depth, primitive_id,
/// unshadowed_irradiance; those that were there.
struct EngineSurfaces {
  Image channels;
  std::vector<uint8_t> has_data;            // [height][width]; empty: everywhere
  std::vector<std::string> not_understood;  // names that were there, when nothing else was
  bool understood() const { return !channels.planes.empty(); }
};

/// Surfaces of all `files`, each FILE or KIND=FILE with a KIND of position, normal, depth; "choice.part" is of all of them.
/// Error{input} for files of several sizes.
EngineSurfaces read_surfaces(const std::vector<std::string>& files, const std::string& part = {});

}  // namespace umbrameter
