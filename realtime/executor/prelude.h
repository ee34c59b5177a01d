// SPDX-License-Identifier: Apache-2.0
#pragma once
// The text put before every technique shader: defines, uniform blocks, samplers and outputs, generated from
// the manifest (docs/technique-manifest.md, "What a shader sees"). No GL calls.

#include "realtime/manifest/technique.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace umbrameter {

struct TextureFormat;  // realtime/harness/objects.h
class BufferTargets;   // realtime/executor/buffer_targets.h

/// Uniform buffer bindings of the prelude's blocks, after kFrameBinding of realtime/harness/frame_uniforms.h.
inline constexpr unsigned kParameterBinding = 1;
inline constexpr unsigned kLoopBinding = 2;
inline constexpr unsigned kFirstViewBinding = 3;
inline constexpr unsigned kHistoryBinding = 35;  // the last of the 36 that every GL has

/// Storage bindings of a pass's buffers, after those of the scene (realtime/harness/scene_buffers.h) and its data that the
/// pass reads (realtime/graph/scene_read.h). Pass by pass: GL promises 8.
inline constexpr unsigned kFirstStorageBinding = 5;

/// A storage buffer as a pass's shaders see it.
struct BufferSlot {
  std::string name;
  unsigned binding = 0;
  bool is_written = false;
};

/// The buffers of a pass that the run has: what it reads, then what it writes.
std::vector<BufferSlot> buffer_slots(const PassDeclaration& pass, const BufferTargets& buffers);

struct PreludeInputs {
  const Technique& technique;
  const ParameterValues& values;
  const PassDeclaration& pass;
  std::vector<std::string> loop_variables;    // outermost first
  std::map<std::string, size_t> view_counts;  // of the views in pass.views
  /// Format of a resource or built-in that exists in this run, else null.
  std::function<const TextureFormat*(const std::string&)> format_of;
  const BufferTargets* buffers = nullptr;  // none: the run has no buffers
  bool takes_blocker_truth = false;        // realtime/executor/blocker_truth.h
  bool scene_has_cutouts = false;
  bool scene_has_instances = false;
};

/// Before a vertex shader, and (with the outputs) before a fragment shader.
std::string vertex_prelude(const PreludeInputs& inputs);
std::string fragment_prelude(const PreludeInputs& inputs);
/// Before a compute shader: with images instead of outputs.
std::string compute_prelude(const PreludeInputs& inputs);

/// The views whose blocks the pass sees: `views`, then `view` unless listed. Block k is at kFirstViewBinding
/// + k.
std::vector<std::string> pass_views(const PassDeclaration& pass);

/// The parameter block as the GPU wants it; empty when the technique has no uniform parameters.
std::vector<std::byte> parameter_block(const Technique& technique, const ParameterValues& values);

}  // namespace umbrameter
