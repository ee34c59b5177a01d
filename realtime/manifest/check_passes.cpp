// SPDX-License-Identifier: Apache-2.0
#include "core/names.h"
#include "realtime/graph/scene_read.h"
#include "realtime/harness/objects.h"
#include "realtime/manifest/check_technique.h"
#include "realtime/manifest/names.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace umbrameter {
namespace {

using NameSet = std::set<std::string, std::less<>>;

/// The first of a resource's formats. Shaders are written for one kind of texel.
const TextureFormat& alike_formats(const ResourceDeclaration& resource) {
  const TextureFormat& first = find_texture_format(resource.formats.front(), resource.where);
  for (const std::string& name : resource.formats) {
    const TextureFormat& other = find_texture_format(name, resource.where);
    if (other.components == first.components && other.is_depth == first.is_depth &&
        other.is_integer == first.is_integer)
      continue;
    fail_input(fmt::format("resource '{}' may be {} or {}, which shaders read in two ways", resource.name,
                           first.name, name),
               resource.where, "the formats of one resource have as many channels of one kind");
  }
  return first;
}

/// Walks the passes in the order they run and remembers what has happened so far.
class PassChecker {
 public:
  explicit PassChecker(const Technique& technique) : technique_(technique) {
    for (const ResourceDeclaration& resource : technique.resources) {
      formats_[resource.name] = &alike_formats(resource);
      if (resource.kind != TextureKind::flat) layered_.insert(resource.name);
      known_writes_.push_back(resource.name);
    }
    for (const BufferDeclaration& buffer : technique.buffers) {
      buffers_[buffer.name] = buffer.element;
      known_writes_.push_back(buffer.name);
    }
    formats_[std::string(kVisibility)] = &find_texture_format("r32f");
    known_writes_.emplace_back(kVisibility);
    known_reads_ = known_writes_;
    known_reads_.insert(known_reads_.end(), builtin_reads().begin(), builtin_reads().end());
    const std::vector<std::string> of_this_frame = known_reads_;
    for (const std::string& name : of_this_frame) {
      if (name != kVisibility && name != kBlueNoise) known_reads_.push_back(std::string(kPrevious) + name);
    }
    for (const SceneReadInfo& read : scene_reads()) known_reads_.emplace_back(read.name);
  }

  void check_all() {
    check(technique_.passes, {});
    if (!written_.contains(kVisibility)) {
      fail_input(fmt::format("technique '{}' never writes 'visibility'", technique_.id),
                 {(technique_.folder / "technique.toml").string(), 0, 0},
                 "one pass must list it in 'writes'");
    }
    check_resources();
    check_buffers();
    check_views();
    check_history();
  }

 private:
  [[noreturn]] static void fail(const PassDeclaration& pass, const std::string& message,
                                const std::string& hint = {}) {
    fail_input(fmt::format("pass '{}' {}", pass.id, message), pass.where, hint);
  }

  void check(const std::vector<PassDeclaration>& passes, const NameSet& loop_variables) {
    for (const PassDeclaration& pass : passes) {
      if (!ids_.insert(pass.id).second) fail(pass, "stands here a second time", "ids are unique");
      if (pass.kind == PassKind::loop) {
        NameSet inner = loop_variables;
        inner.insert({pass.loop_variable, pass.loop_variable + "_count"});
        check(pass.body, inner);
        continue;
      }
      check_used_views(pass, loop_variables);
      check_reads(pass);
      if (pass.once) check_once(pass);
      check_writes(pass);
    }
  }

  void check_used_views(const PassDeclaration& pass, const NameSet& loop_variables) {
    std::vector<std::string> used = pass.views;
    if (!pass.view.empty()) used.push_back(pass.view);
    std::vector<std::string> known;
    for (const ViewDeclaration& view : technique_.views) known.push_back(view.name);
    for (const std::string& name : used) {
      const auto view = std::ranges::find(technique_.views, name, &ViewDeclaration::name);
      if (view == technique_.views.end()) {
        fail(pass, fmt::format("uses the view '{}', which is not declared", name), suggest_name(name, known));
      }
      used_views_.insert(name);
      if (name == pass.view) check_member(pass, *view);
      if (!view->is_family()) check_loop_names(pass, *view, loop_variables);
    }
  }

  /// A pass draws from one view: of a family it says which, and its shaders see that one alone.
  static void check_member(const PassDeclaration& pass, const ViewDeclaration& view) {
    if (view.is_family() && pass.view_index.is_empty())
      fail(pass, fmt::format("draws from the views '{}' and does not say from which", view.name),
           "add 'view_index'");
    if (!view.is_family() && !pass.view_index.is_empty())
      fail(pass, fmt::format("has a 'view_index', but '{}' is a single view", view.name),
           "leave it out, or give the view a 'count'");
    if (view.is_family() && std::ranges::find(pass.views, view.name) != pass.views.end())
      fail(pass, fmt::format("draws from one of the views '{}' and lists them all in 'views'", view.name));
  }

  /// A view that depends on a loop variable can only be used inside that loop.
  void check_loop_names(const PassDeclaration& pass, const ViewDeclaration& view,
                        const NameSet& loop_variables) {
    const NameSet all = all_loop_variables(technique_.passes);
    std::vector<const Expression*> expressions = {&view.index, &view.snap, &view.size};
    for (const auto* pair : {&view.slice_world, &view.offset_texels})
      if (*pair)
        for (const Expression& expression : **pair) expressions.push_back(&expression);
    for (const Expression* expression : expressions) {
      for (const std::string& name : expression->names()) {
        if (!all.contains(name) || loop_variables.contains(name)) continue;
        fail(pass, fmt::format("uses the view '{}' outside the loop over '{}'", view.name, name));
      }
    }
  }

  static NameSet all_loop_variables(const std::vector<PassDeclaration>& passes) {
    NameSet names;
    for (const PassDeclaration& pass : passes) {
      if (pass.kind != PassKind::loop) continue;
      names.insert({pass.loop_variable, pass.loop_variable + "_count"});
      names.merge(all_loop_variables(pass.body));
    }
    return names;
  }

  void check_reads(const PassDeclaration& pass) {
    NameSet reads;
    for (const std::string& name : pass.reads) {
      if (std::ranges::find(known_reads_, name) == known_reads_.end()) {
        fail(pass, fmt::format("reads '{}', which is neither a resource nor built in", name),
             suggest_name(name, known_reads_));
      }
      if (!reads.insert(name).second) fail(pass, fmt::format("reads '{}' twice", name));
      check_read_and_written(pass, name);
      if (is_previous(name)) {
        check_previous(pass, name);
        continue;
      }
      const bool is_builtin = find_scene_read(name) != nullptr ||
                              std::ranges::find(builtin_reads(), name) != builtin_reads().end();
      if (!is_builtin && !written_.contains(name)) {
        fail(pass, fmt::format("reads '{}', which no earlier pass writes", name));
      }
      read_.insert(name);
    }
  }

  void check_read_and_written(const PassDeclaration& pass, const std::string& name) const {
    if (std::ranges::find(pass.writes, name) == pass.writes.end()) return;
    if (buffers_.contains(name))
      fail(pass, fmt::format("reads and writes '{}'", name),
           "leave it out of 'reads': a buffer that a shader writes it sees, too");
    if (pass.write_level.is_empty())
      fail(pass, fmt::format("reads and writes '{}'", name), "only with 'write_level'");
  }

  void check_previous(const PassDeclaration& pass, const std::string& name) {
    if (!technique_.has_history())
      fail(pass, fmt::format("reads '{}', but the technique has no history", name),
           "say with 'frames_before' how many frames are drawn before the one that counts");
    const std::string base(without_previous(name));
    const auto resource = std::ranges::find(technique_.resources, base, &ResourceDeclaration::name);
    if (resource != technique_.resources.end() && !resource->samples.is_empty())
      fail(pass, fmt::format("reads '{}', which is multisampled", name), "leave out 'samples'");
    if (resource != technique_.resources.end() && has_stencil(*formats_.at(base)))
      fail(pass, fmt::format("reads '{}', which has a stencil", name), "take a format without");
    reads_history_ = true;
    read_.insert(base);
  }

  /// What runs once may depend on parameters only.
  void check_once(const PassDeclaration& pass) {
    if (!pass.view.empty() || !pass.views.empty() || pass.kind == PassKind::scene)
      fail(pass, "runs once but depends on the scene", "leave out 'once'");
    for (const std::string& name : pass.reads) {
      if (!written_once_.contains(name))
        fail(pass, fmt::format("runs once but reads '{}', which changes", name), "leave out 'once'");
    }
    written_once_.insert(pass.writes.begin(), pass.writes.end());
  }

  static bool draws(const PassDeclaration& pass) {
    return pass.kind == PassKind::scene || pass.kind == PassKind::fullscreen;
  }

  [[noreturn]] static void fail_buffer(const PassDeclaration& pass, const std::string& name) {
    fail(pass, fmt::format("writes '{}', which is a buffer", name), "only kind = \"compute\" writes buffers");
  }

  void check_stored(const PassDeclaration& pass, const std::string& name) const {
    const auto resource = std::ranges::find(technique_.resources, name, &ResourceDeclaration::name);
    if (!buffers_.contains(name) && formats_.at(name)->is_depth)
      fail(pass, fmt::format("stores into '{}' of the format {}", name, formats_.at(name)->name),
           "no image is of a depth format: take r32f");
    if (resource != technique_.resources.end() && !resource->samples.is_empty())
      fail(pass, fmt::format("stores into '{}', which is multisampled", name), "leave out 'samples'");
    if (pass.state.clear || pass.overwrites || written_.contains(name)) return;
    fail(pass, fmt::format("stores into '{}' before anything is in it", name),
         "add 'clear', or 'overwrites = true' where the shader writes all of it and reads none");
  }

  void check_mipmap(const PassDeclaration& pass, const std::string& name) const {
    if (buffers_.contains(name)) fail_buffer(pass, name);
    if (name == kVisibility || !written_.contains(name))
      fail(pass, fmt::format("makes the levels of '{}' before level 0 is written", name));
    if (formats_.at(name)->is_depth || formats_.at(name)->is_integer)
      fail(pass, fmt::format("cannot average '{}'", name), "colour formats only");
  }

  /// Numbers that no component takes, or that none holds, would be cut off without a word.
  void check_clear(const PassDeclaration& pass) const {
    if (!pass.state.clear) return;
    size_t most_components = 1;
    for (const std::string& name : pass.writes) {
      const auto buffer = buffers_.find(name);
      const bool is_buffer = buffer != buffers_.end();
      const int components = is_buffer ? buffer->second->components : formats_.at(name)->components;
      most_components = std::max(most_components, static_cast<size_t>(components));
      if (is_buffer)
        check_clear_values(pass, name, buffer->second->scalar);
      else if (formats_.at(name)->is_integer)
        check_clear_values(pass, name, ElementScalar::unsigned_integer);
    }
    const size_t count = pass.state.clear->size();
    if (pass.kind == PassKind::compute && count > most_components)
      fail(pass, fmt::format("clears with {} numbers what has {}", count, most_components),
           "at most one per component; the last is repeated");
  }

  static void check_clear_values(const PassDeclaration& pass, const std::string& name, ElementScalar scalar) {
    if (scalar == ElementScalar::real) return;
    const bool is_signed = scalar == ElementScalar::integer;
    const double lowest = is_signed ? std::numeric_limits<int32_t>::min() : 0.0;
    const double highest =
        is_signed ? std::numeric_limits<int32_t>::max() : std::numeric_limits<uint32_t>::max();
    for (const double value : *pass.state.clear) {
      if (value == std::floor(value) && value >= lowest && value <= highest) continue;
      fail(pass, fmt::format("clears '{}' to {}, which its integers cannot hold", name, value),
           fmt::format("whole numbers from {:.0f} to {:.0f}", lowest, highest));
    }
  }

  void check_writes(const PassDeclaration& pass) {
    constexpr int kMaxColors = 8;
    if (pass.writes.empty()) fail(pass, "writes nothing", "writes = [\"visibility\"] or resources");
    NameSet writes;
    int colors = 0;
    int depths = 0;
    for (const std::string& name : pass.writes) {
      if (std::ranges::find(known_writes_, name) == known_writes_.end()) {
        fail(pass, fmt::format("writes '{}', which is no resource", name), suggest_name(name, known_writes_));
      }
      if (!writes.insert(name).second) fail(pass, fmt::format("writes '{}' twice", name));
      if (pass.kind == PassKind::mipmap) {
        check_mipmap(pass, name);
        continue;
      }
      if (pass.kind == PassKind::compute) {
        check_stored(pass, name);
        continue;
      }
      if (buffers_.contains(name)) fail_buffer(pass, name);
      (formats_.at(name)->is_depth ? depths : colors) += 1;
      check_contents(pass, name);
    }
    check_clear(pass);
    if (draws(pass)) check_layer(pass);
    if (draws(pass)) check_state(pass);
    if (depths > 1) fail(pass, "writes more than one depth resource");
    if (colors > kMaxColors) fail(pass, fmt::format("writes more than {} colour resources", kMaxColors));
    if (colors > 0 && pass.fragment.empty()) fail(pass, "writes colour without a 'fragment' shader");
    for (const std::string& name : pass.writes) {
      written_.insert(name);
      if (colors > 0 && formats_.at(name)->is_depth) depth_for_colors_.insert(name);
    }
  }

  void check_layer(const PassDeclaration& pass) const {
    const auto layered =
        std::ranges::find_if(pass.writes, [&](const auto& name) { return layered_.contains(name); });
    if (layered != pass.writes.end() && pass.write_layer.is_empty())
      fail(pass, fmt::format("writes '{}' and does not say which layer", *layered), "add 'write_layer'");
    if (layered == pass.writes.end() && !pass.write_layer.is_empty())
      fail(pass, "has a 'write_layer', but writes nothing with layers");
  }

  /// Blending, and drawing that leaves texels out, need something in the target.
  void check_contents(const PassDeclaration& pass, const std::string& name) const {
    if (pass.state.viewport && name == kVisibility && !written_.contains(name))
      fail(pass, "draws into a part of 'visibility' before the whole is written",
           "let an earlier pass write every pixel");
    if (pass.state.clear || written_.contains(name)) return;
    if (pass.state.blend != BlendMode::none)
      fail(pass, fmt::format("blends into '{}' before anything is in it", name), "add 'clear'");
    if (leaves_texels_out(pass))
      fail(pass, fmt::format("draws into '{}' before anything is in it", name), "add 'clear'");
  }

  void check_state(const PassDeclaration& pass) const {
    const PassState& state = pass.state;
    const auto depth = std::ranges::find_if(
        pass.writes, [&](const std::string& name) { return formats_.at(name)->is_depth; });
    const bool has_depth = depth != pass.writes.end();
    if ((state.stencil || state.clear_stencil) && (!has_depth || !has_stencil(*formats_.at(*depth))))
      fail(pass, "uses a stencil, but writes no format that has one",
           "depth24_stencil8 or depth32f_stencil8");
    if ((state.depth_test || !state.depth_write) && !has_depth)
      fail(pass, "says how depth is tested, but writes none", "list a depth resource in 'writes'");
    if (state.blend != BlendMode::add && state.blend_factors != PassState{}.blend_factors)
      fail(pass, "has 'blend_factors', which only blend = \"add\" takes");
  }

  void check_resources() const {
    for (const ResourceDeclaration& resource : technique_.resources) {
      const TextureFormat& format = *formats_.at(resource.name);
      const auto fail_resource = [&](std::string_view message, const std::string& hint = {}) {
        fail_input(fmt::format("resource '{}' {}", resource.name, message), resource.where, hint);
      };
      if (resource.compare && !format.is_depth)
        fail_resource("cannot be compared", "compare = true needs depth32f");
      if (format.is_integer && resource.filter != TextureFilter::nearest)
        fail_resource("holds integers, which cannot be filtered");
      if (!written_.contains(resource.name)) fail_resource("is never written");
      if (!read_.contains(resource.name) && !depth_for_colors_.contains(resource.name))
        fail_resource("is never read");
    }
  }

  void check_buffers() const {
    for (const BufferDeclaration& buffer : technique_.buffers) {
      const auto fail_unless = [&](bool is_fine, std::string_view message) {
        if (!is_fine) fail_input(fmt::format("buffer '{}' {}", buffer.name, message), buffer.where);
      };
      fail_unless(written_.contains(buffer.name), "is never written");
      fail_unless(read_.contains(buffer.name), "is never read");
    }
  }

  void check_views() const {
    for (const ViewDeclaration& view : technique_.views) {
      if (!used_views_.contains(view.name))
        fail_input(fmt::format("view '{}' is never used", view.name), view.where);
    }
  }

  /// A technique whose frames are all alike needs one.
  void check_history() const {
    if (technique_.has_history() && !reads_history_)
      fail_input(fmt::format("technique '{}' draws frames before and reads nothing of them", technique_.id),
                 technique_.frames_before.where(), "read previous.<resource>, or leave out 'frames_before'");
  }

  const Technique& technique_;
  bool reads_history_ = false;
  std::map<std::string, const TextureFormat*, std::less<>> formats_;
  std::vector<std::string> known_reads_;
  std::vector<std::string> known_writes_;
  NameSet ids_, written_, written_once_, read_, used_views_;
  std::map<std::string, const ElementType*, std::less<>> buffers_;
  NameSet layered_;           // resources with layers
  NameSet depth_for_colors_;  // depth resources that only serve the depth test of a pass with colours
};

}  // namespace

bool leaves_texels_out(const PassDeclaration& pass) {
  return pass.kind == PassKind::scene || pass.state.stencil || pass.state.depth_test || pass.state.viewport ||
         (pass.kind == PassKind::compute && !pass.overwrites);
}

void check_passes(const Technique& technique) {
  check_identifiers(technique);
  check_views(technique);
  PassChecker(technique).check_all();
}

}  // namespace umbrameter
