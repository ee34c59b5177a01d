// SPDX-License-Identifier: Apache-2.0
#pragma once
// Compiling, linking, caching and reflecting GL programs.

#include "realtime/harness/objects.h"
#include "realtime/harness/shader_source.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

enum class ShaderStage { vertex, fragment, compute };
/// "vertex", "fragment", "compute".
std::string_view to_text(ShaderStage stage);

struct ShaderFile {
  ShaderStage stage = ShaderStage::vertex;
  std::filesystem::path file;
  std::string prelude;           // put between #version and the file; may itself #include
  bool places_vertices = false;  // with_placed_vertices() changes the text
};

struct StageText {
  ShaderStage stage = ShaderStage::vertex;
  std::string text;
};

class Program {
 public:
  /// Compiles and links. Error{input} at the user's file and line when the text is wrong.
  Program(std::span<const ShaderFile> stages, std::span<const std::filesystem::path> search_folders);
  GLuint id() const { return handle_.id(); }
  void use() const { glUseProgram(id()); }
  /// Every file that was read.
  const std::vector<std::filesystem::path>& dependencies() const { return dependencies_; }
  /// Driver warnings as "file:line: text".
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// What went to the driver, by stage, in the order of the stages.
  const std::vector<StageText>& texts() const { return texts_; }
  /// Of the texts: equal for programs that do the same.
  const std::string& key() const { return key_; }
  /// The samplers that it uses.
  const std::vector<std::string>& samplers() const { return samplers_; }
  /// Whether a stage's text names a uniform besides declaring it.
  bool reads_uniform(const std::string& name) const;
  /// Whether a stage's text names gl_PrimitiveID: which triangles are drawn together matters to it.
  bool names_primitive_id() const { return names_primitive_id_; }

 private:
  friend class ProgramCache;
  Program(std::span<const ShaderFile> stages, std::span<const ShaderSource> sources);
  GlHandle<destroy_program> handle_;
  std::vector<std::filesystem::path> dependencies_;
  std::vector<std::string> warnings_;
  std::vector<StageText> texts_;
  std::string key_;
  std::vector<std::string> samplers_;
  std::vector<std::string> repeated_words_;  // of any stage, in alphabetical order
  bool names_primitive_id_ = false;
};

/// Programs by the hash of their full text, so an edited file is noticed and an unchanged one is not recompiled. Macros that
/// a shader never names are left out of it: what only they tell apart is compiled once. Files are read again only when the
/// time or size of one has changed, or the time of its folder.
class ProgramCache {
 public:
  /// `search_folders`: where #include "x" looks after the including file's own folder.
  explicit ProgramCache(std::vector<std::filesystem::path> search_folders);
  std::shared_ptr<const Program> get(std::span<const ShaderFile> stages);
  const std::vector<std::filesystem::path>& search_folders() const { return search_folders_; }

 private:
  /// What was asked for last, and the state its files were in.
  struct Known {
    std::shared_ptr<const Program> program;
    std::vector<std::filesystem::path> files;
    std::optional<std::vector<int64_t>> stamps;
  };

  std::shared_ptr<const Program> read(std::span<const ShaderFile> stages, Known& known);

  std::vector<std::filesystem::path> search_folders_;
  std::map<std::string, Known> known_;  // by files and preludes
  std::map<std::string, std::shared_ptr<const Program>> programs_;
};

/// A member of a uniform block as the driver lays it out. `name` is without the block's or instance's name
/// ("frame.eye_world" for a member of a struct).
struct BlockMember {
  std::string name;
  GLenum type = 0;
  int offset_bytes = 0;
};

/// Members of block `block`, by offset; empty when the program has no such active block.
std::vector<BlockMember> uniform_block_members(const Program& program, std::string_view block);
/// Bytes of block `block`, 0 when it is not active.
int uniform_block_bytes(const Program& program, std::string_view block);
/// Names of the samplers (and other default-block uniforms) the linked program uses.
std::vector<std::string> active_uniforms(const Program& program);

}  // namespace umbrameter
