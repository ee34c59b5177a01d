// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/engine_channels.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace umbrameter {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// Small letters and digits only: "World Position" and "world_position" are one name.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

struct NameMeaning {
  LayerKind kind;
  int preference;
};

const std::map<std::string, NameMeaning, std::less<>>& known_names() {
  using enum LayerKind;
  static const std::map<std::string, NameMeaning, std::less<>> names = {
      {"visibility", {visibility, 0}},
      // Pictures. "" is R, G, B without a layer.
      {"", {color, 0}},
      {"combined", {color, 0}},
      {"beauty", {color, 1}},
      {"rgba", {color, 1}},
      {"rgb", {color, 1}},
      {"rgbcolor", {color, 1}},
      {"finalimage", {color, 1}},
      {"composite", {color, 2}},
      {"image", {color, 2}},
      {"color", {color, 2}},
      {"colour", {color, 2}},
      {"radiance", {color, 2}},
      // Places in world space.
      {"position", {position, 0}},
      {"positions", {position, 0}},
      {"worldposition", {position, 0}},
      {"positionworld", {position, 0}},
      {"worldpos", {position, 0}},
      {"worldpoint", {position, 0}},
      {"pointworld", {position, 0}},
      {"pworld", {position, 0}},
      {"posw", {position, 0}},
      {"positionw", {position, 0}},
      {"wpos", {position, 0}},
      {"pos", {position, 1}},
      {"p", {position, 1}},
      {"wpp", {position, 1}},
      {"samplerinfo", {position, 2}},
      // Normals, those of the triangles first.
      {"geonormal", {normal, 0}},
      {"geometricnormal", {normal, 0}},
      {"geometricnormals", {normal, 0}},
      {"geometrynormal", {normal, 0}},
      {"facenormal", {normal, 0}},
      {"facenormalw", {normal, 0}},
      {"ng", {normal, 0}},
      {"ngn", {normal, 0}},
      {"normal", {normal, 1}},
      {"normals", {normal, 1}},
      {"normalworld", {normal, 1}},
      {"worldnormal", {normal, 1}},
      {"worldnormals", {normal, 1}},
      {"normalw", {normal, 1}},
      {"normw", {normal, 1}},
      {"n", {normal, 1}},
      {"nn", {normal, 1}},
      {"shnormal", {normal, 2}},
      {"shadingnormal", {normal, 2}},
      {"guidenormalw", {normal, 2}},
      {"ns", {normal, 2}},
      // Depth along the camera's axis or the ray.
      {"depth", {depth, 0}},
      {"z", {depth, 0}},
      {"zdepth", {depth, 0}},
      {"worlddepth", {depth, 0}},
      {"lineardepth", {depth, 0}},
      {"linearz", {depth, 0}},
      {"viewdepth", {depth, 0}},
      {"viewz", {depth, 0}},
      {"scenedepth", {depth, 0}},
      {"pz", {depth, 0}},
      {"distance", {depth, 1}},
      {"dd", {depth, 1}},
      {"primitiveid", {primitive_id, 0}},
      {"unshadowedirradiance", {unshadowed_irradiance, 0}},
      // Grey pictures.
      {"y", {grey, 0}},
      {"l", {grey, 0}},
      {"luminance", {grey, 0}},
      {"grey", {grey, 0}},
      {"gray", {grey, 0}},
      {"r", {grey, 1}},
      {"red", {grey, 1}},
      // Neither pictures nor surfaces that parity reads.
      {"a", {other, 0}},
      {"alpha", {other, 0}},
      {"opacity", {other, 0}},
      {"coverage", {other, 0}},
      {"albedo", {other, 0}},
      {"diffcol", {other, 0}},
      {"basecolor", {other, 0}},
      {"emission", {other, 0}},
      {"uv", {other, 0}},
      {"u", {other, 0}},
      {"st", {other, 0}},
      {"texc", {other, 0}},
      {"vector", {other, 0}},
      {"velocity", {other, 0}},
      {"motion", {other, 0}},
      {"motionvector", {other, 0}},
      {"mvec", {other, 0}},
      {"mist", {other, 0}},
      {"bumpnormals", {other, 0}},
      {"pref", {other, 0}},
      {"id", {other, 0}},
      {"indexob", {other, 0}},
      {"indexma", {other, 0}},
      {"objectid", {other, 0}},
      {"materialid", {other, 0}},
      {"shapeindex", {other, 0}},
      {"primindex", {other, 0}},
      {"tangent", {other, 0}},
      {"tangentw", {other, 0}},
      {"variance", {other, 0}},
      {"samplecount", {other, 0}},
  };
  return names;
}

std::vector<std::string> split(std::string_view text, std::string_view separators) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (separators.find(c) == std::string_view::npos) {
      parts.back() += c;
    } else {
      parts.emplace_back();
    }
  }
  return parts;
}

/// The meaning of a layer's name: of its last word, of the words behind a prefix, of the word before a number.
std::optional<NameMeaning> meaning_of(std::string_view layer) {
  std::vector<std::string> words = split(layer, ".:/");
  while (words.size() > 1 &&
         std::ranges::all_of(words.back(), [](unsigned char c) { return std::isdigit(c); }))
    words.pop_back();
  const auto& names = known_names();
  const std::string whole = plain(words.back());
  for (std::string name :
       {whole, whole.starts_with("vray") ? whole.substr(4) : whole, plain(split(words.back(), "_").back())}) {
    if (const auto found = names.find(name); found != names.end()) return found->second;
  }
  return std::nullopt;
}

struct ChannelName {
  std::string layer;
  std::string component;  // "r", "x", "z", ...; empty when the name has none
};

std::string component_of(std::string_view word) {
  static const std::map<std::string, std::string, std::less<>> known = {
      {"r", "r"},     {"g", "g"},    {"b", "b"},     {"a", "a"}, {"red", "r"},
      {"green", "g"}, {"blue", "b"}, {"alpha", "a"}, {"x", "x"}, {"y", "y"},
      {"z", "z"},     {"v", "v"},    {"t", "t"},     {"u", "u"}, {"w", "w"}};
  const auto found = known.find(lower(word));
  return found == known.end() ? std::string() : found->second;
}

ChannelName parse(const std::string& channel) {
  const size_t dot = channel.rfind('.');
  const std::string component = component_of(
      dot == std::string::npos ? std::string_view(channel) : std::string_view(channel).substr(dot + 1));
  if (component.empty()) return {channel, ""};
  return {dot == std::string::npos ? "" : channel.substr(0, dot), component};
}

using Components = std::map<std::string, std::string>;  // component -> channel

std::optional<std::vector<std::string>> triple(const Components& parts, std::array<const char*, 3> wanted) {
  std::vector<std::string> channels;
  for (const char* component : wanted) {
    const auto found = parts.find(component);
    if (found == parts.end()) return std::nullopt;
    channels.push_back(found->second);
  }
  return channels;
}

Layer make(std::string name, const std::optional<NameMeaning>& meaning, LayerKind otherwise,
           std::vector<std::string> channels) {
  Layer layer;
  layer.name = std::move(name);
  layer.channels = std::move(channels);
  layer.kind = meaning ? meaning->kind : otherwise;
  layer.preference = meaning ? meaning->preference : 9;
  layer.is_known_name = meaning.has_value();
  const bool has_three = layer.channels.size() == 3;
  const bool needs_three =
      layer.kind == LayerKind::color || layer.kind == LayerKind::position || layer.kind == LayerKind::normal;
  if (needs_three && !has_three)
    layer.kind = layer.kind == LayerKind::color ? LayerKind::grey : LayerKind::other;
  if (!needs_three && has_three && layer.kind == LayerKind::grey) layer.kind = LayerKind::color;
  // A depth or a visibility of three channels holds it three times.
  if (has_three && layer.kind != LayerKind::color && !needs_three) layer.channels.resize(1);
  return layer;
}

/// The layers of channels that share all but their last word.
void add_layers(const std::string& name, Components parts, std::vector<Layer>& layers) {
  const bool is_top = name.empty();
  parts.erase("a");
  const auto meaning = meaning_of(name);
  const auto take = [&](const std::vector<std::string>& channels) {
    for (const std::string& channel : channels)
      std::erase_if(parts, [&](const auto& part) { return part.second == channel; });
  };
  if (const auto rgb = triple(parts, {"r", "g", "b"})) {
    layers.push_back(make(name, meaning, LayerKind::color, *rgb));
    take(*rgb);
  }
  if (const auto xyz = triple(parts, {"x", "y", "z"})) {
    // At the top they may be places or directions: nobody can tell.
    layers.push_back(make(name, is_top ? std::nullopt : meaning, LayerKind::other, *xyz));
    take(*xyz);
  }
  for (const auto& [component, channel] : parts) {
    const auto own = is_top ? meaning_of(channel) : meaning;
    layers.push_back(make(is_top ? channel : name, own, LayerKind::grey, {channel}));
  }
}

bool is_equal(std::string_view a, std::string_view b) {
  return lower(a) == lower(b);
}

/// Whether `name` is `wanted`, or ends with ".wanted".
bool is_called(std::string_view name, std::string_view wanted) {
  if (is_equal(name, wanted)) return true;
  return name.size() > wanted.size() && name[name.size() - wanted.size() - 1] == '.' &&
         is_equal(name.substr(name.size() - wanted.size()), wanted);
}

}  // namespace

std::vector<Layer> find_layers(std::span<const std::string> names) {
  std::map<std::string, Components> groups;
  std::vector<Layer> layers;
  for (const std::string& channel : names) {
    const ChannelName parsed = parse(channel);
    if (parsed.component.empty()) {
      layers.push_back(make(channel, meaning_of(channel), LayerKind::grey, {channel}));
    } else {
      groups[parsed.layer].try_emplace(parsed.component, channel);
    }
  }
  for (auto& [name, parts] : groups) add_layers(name, std::move(parts), layers);
  return layers;
}

std::optional<Layer> layer_called(std::string_view wanted, std::span<const std::string> names) {
  const auto lone = [&](const auto& matches) -> std::optional<Layer> {
    const auto found = std::ranges::find_if(names, matches);
    if (found == names.end()) return std::nullopt;
    return Layer{*found, LayerKind::grey, {*found}, 0, true};
  };
  if (auto exact = lone([&](const std::string& name) { return name == wanted; })) return exact;
  for (const Layer& layer : find_layers(names)) {
    if (layer.channels.size() != 3 || !is_called(layer.name, wanted)) continue;
    Layer chosen = layer;
    chosen.kind = LayerKind::color;
    return chosen;
  }
  return lone([&](const std::string& name) { return is_called(name, wanted); });
}

std::optional<LayerKind> kind_of_file_name(std::string_view file) {
  const size_t slash = file.find_last_of("/\\");
  std::vector<std::string> words =
      split(slash == std::string_view::npos ? file : file.substr(slash + 1), ".-_ ");
  if (words.size() > 1) words.pop_back();  // the extension
  std::optional<LayerKind> kind;
  for (const std::string& word : words) {
    const std::string name = plain(word);
    if (name.size() < 3) continue;  // "p" and "n" are words of other names, too
    const auto found = known_names().find(name);
    if (found == known_names().end()) continue;
    const LayerKind meant = found->second.kind;
    if (meant == LayerKind::position || meant == LayerKind::normal || meant == LayerKind::depth) kind = meant;
  }
  return kind;
}

}  // namespace umbrameter
