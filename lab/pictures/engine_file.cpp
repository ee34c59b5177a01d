// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/engine_file.h"

#include "core/error.h"
#include "core/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace umbrameter {
namespace {

/// A layer with the part that has it.
struct Candidate {
  size_t part = 0;
  Layer layer;
};

std::vector<std::string> channel_names(const Image& image) {
  std::vector<std::string> names;
  for (const auto& [name, plane] : image.planes) names.push_back(name);
  return names;
}

std::string part_name(const std::vector<ImagePart>& parts, size_t index) {
  const std::string& name = parts[index].name;
  return fmt::format("part {}{}", index + 1, name.empty() ? "" : fmt::format(" '{}'", name));
}

/// "part 1 'lit': B, G, R; part 2: visibility", or the channels alone of a single part.
std::string contents(const std::vector<ImagePart>& parts) {
  std::string text;
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string channels = fmt::format("{}", fmt::join(channel_names(parts[i].image), ", "));
    if (parts.size() == 1) return channels;
    text += fmt::format("{}{}: {}", i == 0 ? "" : "; ", part_name(parts, i), channels);
  }
  return text;
}

/// Parts without the others than `wanted`.
std::vector<ImagePart> choose_parts(std::vector<ImagePart> parts, const std::string& wanted,
                                    const std::string& file) {
  if (wanted.empty()) return parts;
  size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = error == std::errc() && end == wanted.data() + wanted.size();
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].name != wanted && !(is_number && number == i + 1)) continue;
    std::vector<ImagePart> chosen;
    chosen.push_back(std::move(parts[i]));
    return chosen;
  }
  fail_input(
      fmt::format("there is no part '{}'", wanted), {file},
      fmt::format("it has {} {}: {}", parts.size(), parts.size() == 1 ? "part" : "parts", contents(parts)));
}

std::string title(const std::vector<ImagePart>& parts, const Candidate& candidate) {
  const std::string name = candidate.layer.name.empty() ? "R, G, B" : candidate.layer.name;
  return parts.size() == 1 ? fmt::format("'{}'", name)
                           : fmt::format("'{}' of {}", name, part_name(parts, candidate.part));
}

bool may_be_picture(const Layer& layer) {
  return layer.kind == LayerKind::color || layer.kind == LayerKind::grey;
}

[[noreturn]] void fail_no_picture(const std::vector<ImagePart>& parts, const std::string& file) {
  fail_input(fmt::format("no channel is a picture, there {} only {}",
                         parts.size() == 1 && parts.front().image.planes.size() == 1 ? "is" : "are",
                         contents(parts)),
             {file}, "--channel NAME reads one all the same");
}

[[noreturn]] void fail_ambiguous(const std::vector<ImagePart>& parts,
                                 const std::vector<Candidate>& candidates, const std::string& file) {
  std::vector<std::string> titles;
  for (const Candidate& candidate : candidates) titles.push_back(title(parts, candidate));
  fail_input(fmt::format("several layers may be the picture: {}", fmt::join(titles, ", ")), {file},
             "choose with --channel NAME or --part N");
}

/// Those of the lowest preference.
std::vector<Candidate> preferred(const std::vector<Candidate>& candidates) {
  int least = 1 << 30;
  for (const Candidate& candidate : candidates) least = std::min(least, candidate.layer.preference);
  std::vector<Candidate> best;
  for (const Candidate& candidate : candidates) {
    if (candidate.layer.preference == least) best.push_back(candidate);
  }
  return best;
}

Candidate choose_unnamed(const std::vector<ImagePart>& parts, const std::string& file) {
  std::vector<Candidate> visibility, color, grey;
  for (size_t i = 0; i < parts.size(); ++i) {
    for (Layer& layer : find_layers(channel_names(parts[i].image))) {
      const LayerKind kind = layer.kind;
      if (kind == LayerKind::visibility) visibility.push_back({i, layer});
      if (kind == LayerKind::color) color.push_back({i, layer});
      if (kind == LayerKind::grey) grey.push_back({i, layer});
    }
  }
  // Colours before lone channels of any name; lone channels that are called grey before colours of any name.
  std::vector<Candidate> known_grey;
  std::ranges::copy_if(grey, std::back_inserter(known_grey),
                       [](const Candidate& c) { return c.layer.is_known_name; });
  for (const auto& candidates : {visibility, preferred(color), preferred(known_grey), preferred(grey)}) {
    if (candidates.size() == 1) return candidates.front();
    if (candidates.size() > 1) fail_ambiguous(parts, candidates, file);
  }
  fail_no_picture(parts, file);
}

Candidate choose_named(const std::vector<ImagePart>& parts, const std::string& wanted,
                       const std::string& file) {
  std::vector<Candidate> found;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (auto layer = layer_called(wanted, channel_names(parts[i].image))) found.push_back({i, *layer});
  }
  if (found.size() == 1) return found.front();
  if (found.size() > 1) fail_ambiguous(parts, found, file);
  fail_input(fmt::format("there is no channel or layer '{}'", wanted), {file},
             fmt::format("it has {}", contents(parts)));
}

void add_notes(const std::vector<ImagePart>& parts, const Candidate& chosen, const std::string& file,
               PictureChannels& picture) {
  std::vector<std::string> others;
  for (size_t i = 0; i < parts.size(); ++i) {
    for (const Layer& layer : find_layers(channel_names(parts[i].image))) {
      const bool is_chosen = i == chosen.part && layer.channels == chosen.layer.channels;
      if (may_be_picture(layer) && !is_chosen && layer.is_known_name)
        others.push_back(title(parts, {i, layer}));
    }
  }
  if (!others.empty())
    picture.notes.push_back(fmt::format("{}: read {}; the file also has {}, see --channel and --part", file,
                                        title(parts, chosen), fmt::join(others, ", ")));
  if (!chosen.layer.is_known_name)
    picture.notes.push_back(
        fmt::format("{}: read {}, the only layer that may be the picture", file, title(parts, chosen)));
  if (parts[chosen.part].format == "jpeg")
    picture.notes.push_back(fmt::format(
        "{}: JPEG loses detail beyond its rounding, and nothing tells how much; score PNG or EXR", file));
}

constexpr std::array<std::pair<const char*, LayerKind>, 3> kLayerKinds = {
    {{"position", LayerKind::position}, {"normal", LayerKind::normal}, {"depth", LayerKind::depth}}};

struct SurfaceFile {
  std::string path;
  std::optional<LayerKind> kind;  // said by the user
};

SurfaceFile parse_surface_file(const std::string& text) {
  for (const auto& [name, kind] : kLayerKinds) {
    const std::string prefix = std::string(name) + "=";
    if (text.starts_with(prefix)) return {text.substr(prefix.size()), kind};
  }
  return {text, std::nullopt};
}

std::vector<std::string> our_names(LayerKind kind) {
  switch (kind) {
    case LayerKind::position:
      return {"position.x", "position.y", "position.z"};
    case LayerKind::normal:
      return {"normal.x", "normal.y", "normal.z"};
    case LayerKind::depth:
      return {"depth"};
    case LayerKind::primitive_id:
      return {"primitive_id"};
    case LayerKind::unshadowed_irradiance:
      return {"unshadowed_irradiance"};
    default:
      return {};
  }
}

/// A layer whose kind the user or the file's name tells: three channels, or one.
std::optional<Layer> sole_layer(const std::vector<Layer>& layers, LayerKind kind) {
  const size_t wanted = our_names(kind).size();
  const auto fits = [&](const Layer& layer) { return layer.channels.size() >= wanted; };
  if (std::ranges::count_if(layers, fits) != 1) return std::nullopt;
  Layer layer = *std::ranges::find_if(layers, fits);
  layer.kind = kind;
  layer.channels.resize(wanted);
  return layer;
}

/// Best layer of every kind in one part, under our names.
void take_surfaces(const ImagePart& part, const SurfaceFile& file, EngineSurfaces& out) {
  std::vector<Layer> layers = find_layers(channel_names(part.image));
  std::ranges::stable_sort(layers, {}, &Layer::preference);
  const bool has_surfaces = std::ranges::any_of(layers, [](const Layer& layer) {
    return layer.kind == LayerKind::position || layer.kind == LayerKind::normal ||
           layer.kind == LayerKind::depth;
  });
  const auto told = file.kind || has_surfaces ? file.kind : kind_of_file_name(file.path);
  if (told) {
    if (const auto layer = sole_layer(layers, *told)) layers = {*layer};
  }
  for (const Layer& layer : layers) {
    if (told && layer.kind != *told) continue;
    const std::vector<std::string> names = our_names(layer.kind);
    if (names.empty() || layer.channels.size() != names.size() || out.channels.has(names.front())) continue;
    for (size_t i = 0; i < names.size(); ++i) {
      const auto plane = part.image.plane(layer.channels[i]);
      out.channels.planes[names[i]].assign(plane.begin(), plane.end());
    }
  }
}

}  // namespace

PictureChannels read_picture(const std::filesystem::path& path, const PictureChoice& choice) {
  const std::string file = path.string();
  std::vector<ImagePart> parts = choose_parts(read_image_parts(path), choice.part, file);
  const Candidate chosen =
      choice.channel.empty() ? choose_unnamed(parts, file) : choose_named(parts, choice.channel, file);
  PictureChannels picture;
  add_notes(parts, chosen, file, picture);
  picture.channels = chosen.layer.channels;
  picture.part = std::move(parts[chosen.part]);
  return picture;
}

EngineSurfaces read_surfaces(const std::vector<std::string>& files, const std::string& wanted_part) {
  EngineSurfaces out;
  for (const std::string& text : files) {
    const SurfaceFile file = parse_surface_file(text);
    for (const ImagePart& part : choose_parts(read_image_parts(file.path), wanted_part, file.path)) {
      EngineSurfaces more;
      more.channels.width = part.image.width;
      more.channels.height = part.image.height;
      take_surfaces(part, file, more);
      for (const std::string& name : channel_names(part.image)) out.not_understood.push_back(name);
      if (!more.understood()) continue;
      if (!out.understood()) {
        out.channels.width = part.image.width;
        out.channels.height = part.image.height;
        out.has_data.assign(part.has_data.size(), 1);
      }
      require_same_size(out.channels, part.image, "surface channels");
      out.channels.planes.merge(more.channels.planes);
      for (size_t i = 0; i < part.has_data.size(); ++i) out.has_data[i] &= part.has_data[i];
    }
  }
  if (out.understood()) out.not_understood.clear();
  return out;
}

}  // namespace umbrameter
