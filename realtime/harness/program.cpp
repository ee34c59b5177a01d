// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/program.h"

#include "core/hash.h"
#include "realtime/harness/debug_log.h"
#include "realtime/harness/file_stamps.h"
#include "realtime/harness/placed_vertices.h"
#include "realtime/harness/shader_words.h"

#include <algorithm>
#include <array>

namespace umbrameter {

namespace {

void destroy_shader(GLuint id) {
  glDeleteShader(id);
}
using Shader = GlHandle<destroy_shader>;

GLenum gl_stage(ShaderStage stage) {
  switch (stage) {
    case ShaderStage::vertex:
      return GL_VERTEX_SHADER;
    case ShaderStage::fragment:
      return GL_FRAGMENT_SHADER;
    case ShaderStage::compute:
      return GL_COMPUTE_SHADER;
  }
  return GL_NONE;
}

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
  return log;
}

std::string program_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
  glGetProgramInfoLog(program, length, nullptr, log.data());
  log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
  return log;
}

/// Drivers report bad GLSL through KHR_debug as well: told here, it must not fail the next check of GL.
[[noreturn]] void fail_glsl(const std::string& message, const FileLocation& where,
                            const std::string& hint = {}) {
  take_gl_errors();
  fail_input(message, where, hint);
}

/// The first error names the place; the user fixes that one first.
[[noreturn]] void fail_compile(const std::vector<ShaderMessage>& messages, const ShaderFile& file) {
  const auto is_error = [](const ShaderMessage& message) { return message.is_error; };
  auto first = std::find_if(messages.begin(), messages.end(), is_error);
  const auto errors = std::count_if(messages.begin(), messages.end(), is_error);
  if (first == messages.end()) first = messages.begin();
  const std::string text = first == messages.end() ? "the driver gave no reason" : first->text;
  std::string hint = missing_read_hint(text);
  if (hint.empty() && errors > 1) hint = fmt::format("{} more after it", errors - 1);
  const bool has_place = first != messages.end() && !first->where.file.empty();
  fail_glsl("GLSL does not compile: " + text,
            has_place ? first->where : FileLocation{file.file.string(), 0, 0}, hint);
}

Shader compile(const ShaderFile& file, const ShaderSource& source, std::vector<std::string>& warnings) {
  Shader shader(glCreateShader(gl_stage(file.stage)));
  const char* text = source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint is_compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &is_compiled);
  const std::vector<ShaderMessage> messages = parse_shader_log(shader_log(shader.id()), source);
  if (is_compiled == GL_FALSE) fail_compile(messages, file);
  for (const ShaderMessage& message : messages)
    warnings.push_back(to_string(message.where) + ": " + message.text);
  return shader;
}

std::vector<ShaderSource> load_sources(std::span<const ShaderFile> stages,
                                       std::span<const std::filesystem::path> search_folders) {
  std::vector<ShaderSource> sources;
  for (const ShaderFile& stage : stages) {
    sources.push_back(load_shader_source(stage.file, stage.prelude, search_folders));
    sources.back().text = without_idle_macros(sources.back().text);
    if (stage.places_vertices)
      sources.back().text = with_placed_vertices(sources.back().text, stage.file.string());
  }
  return sources;
}

std::string key_of(std::span<const ShaderFile> stages, std::span<const ShaderSource> sources) {
  Hasher hasher;
  for (size_t i = 0; i < stages.size(); ++i)
    hasher.number(static_cast<double>(stages[i].stage)).text(sources[i].text);
  return hasher.hex();
}

void require_linked(GLuint program, std::span<const ShaderFile> stages) {
  GLint is_linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == GL_TRUE) return;
  std::string log = program_log(program);
  std::replace(log.begin(), log.end(), '\n', ' ');
  while (!log.empty() && log.back() == ' ') log.pop_back();
  fail_glsl("GLSL does not link: " + (log.empty() ? "the driver gave no reason" : log),
            {stages.back().file.string(), 0, 0});
}

std::string resource_name(GLuint program, GLenum interface, GLuint index, GLint length) {
  std::string name(static_cast<size_t>(std::max(length, 1)), '\0');
  glGetProgramResourceName(program, interface, index, length, nullptr, name.data());
  name.resize(name.find('\0'));
  return name;
}

GLuint block_index(const Program& program, std::string_view block) {
  return glGetProgramResourceIndex(program.id(), GL_UNIFORM_BLOCK, std::string(block).c_str());
}

GLint block_property(const Program& program, GLuint block, GLenum property) {
  GLint value = 0;
  glGetProgramResourceiv(program.id(), GL_UNIFORM_BLOCK, block, 1, &property, 1, nullptr, &value);
  return value;
}

}  // namespace

Program::Program(std::span<const ShaderFile> stages, std::span<const std::filesystem::path> search_folders)
    : Program(stages, load_sources(stages, search_folders)) {}

Program::Program(std::span<const ShaderFile> stages, std::span<const ShaderSource> sources)
    : key_(key_of(stages, sources)) {
  std::vector<Shader> shaders;
  for (size_t i = 0; i < stages.size(); ++i) {
    shaders.push_back(compile(stages[i], sources[i], warnings_));
    texts_.push_back({stages[i].stage, sources[i].text});
    std::ranges::copy(repeated_words(sources[i].text), std::back_inserter(repeated_words_));
    names_primitive_id_ |= sources[i].text.find("gl_PrimitiveID") != std::string::npos;
    dependencies_.insert(dependencies_.end(), sources[i].dependencies.begin(), sources[i].dependencies.end());
  }
  handle_ = GlHandle<destroy_program>(glCreateProgram());
  for (const Shader& shader : shaders) glAttachShader(id(), shader.id());
  glLinkProgram(id());
  for (const Shader& shader : shaders) glDetachShader(id(), shader.id());
  require_linked(id(), stages);
  samplers_ = active_uniforms(*this);
  std::ranges::sort(repeated_words_);
}

bool Program::reads_uniform(const std::string& name) const {
  return std::ranges::binary_search(repeated_words_, name);
}

std::string_view to_text(ShaderStage stage) {
  switch (stage) {
    case ShaderStage::vertex:
      return "vertex";
    case ShaderStage::fragment:
      return "fragment";
    case ShaderStage::compute:
      return "compute";
  }
  return {};
}

ProgramCache::ProgramCache(std::vector<std::filesystem::path> search_folders)
    : search_folders_(std::move(search_folders)) {}

std::shared_ptr<const Program> ProgramCache::get(std::span<const ShaderFile> stages) {
  Hasher hasher;
  for (const ShaderFile& stage : stages)
    hasher.number(static_cast<double>(stage.stage)).text(stage.file.string()).text(stage.prelude);
  Known& known = known_[hasher.hex()];
  if (known.stamps && stamps_of(known.files) == known.stamps) return known.program;
  return read(stages, known);
}

std::shared_ptr<const Program> ProgramCache::read(std::span<const ShaderFile> stages, Known& known) {
  known = {};
  const std::vector<ShaderSource> sources = load_sources(stages, search_folders_);
  for (const ShaderSource& source : sources)
    known.files.insert(known.files.end(), source.dependencies.begin(), source.dependencies.end());
  const auto stamps = stamps_of(known.files);
  std::shared_ptr<const Program>& program = programs_[key_of(stages, sources)];
  if (program == nullptr) program.reset(new Program(stages, sources));
  known.program = program;
  known.stamps = stamps;  // last: what does not compile is not known
  return program;
}

std::vector<BlockMember> uniform_block_members(const Program& program, std::string_view block) {
  const GLuint index = block_index(program, block);
  if (index == GL_INVALID_INDEX) return {};
  std::vector<GLint> variables(static_cast<size_t>(block_property(program, index, GL_NUM_ACTIVE_VARIABLES)));
  const GLenum active = GL_ACTIVE_VARIABLES;
  glGetProgramResourceiv(program.id(), GL_UNIFORM_BLOCK, index, 1, &active,
                         static_cast<GLsizei>(variables.size()), nullptr, variables.data());
  std::vector<BlockMember> members;
  const std::string prefix = std::string(block) + ".";
  for (const GLint variable : variables) {
    constexpr std::array<GLenum, 3> kProperties = {GL_NAME_LENGTH, GL_TYPE, GL_OFFSET};
    std::array<GLint, 3> values{};
    const auto id = static_cast<GLuint>(variable);
    glGetProgramResourceiv(program.id(), GL_UNIFORM, id, 3, kProperties.data(), 3, nullptr, values.data());
    std::string name = resource_name(program.id(), GL_UNIFORM, id, values[0]);
    if (name.starts_with(prefix)) name.erase(0, prefix.size());
    members.push_back({std::move(name), static_cast<GLenum>(values[1]), values[2]});
  }
  std::sort(members.begin(), members.end(),
            [](const BlockMember& a, const BlockMember& b) { return a.offset_bytes < b.offset_bytes; });
  return members;
}

int uniform_block_bytes(const Program& program, std::string_view block) {
  const GLuint index = block_index(program, block);
  return index == GL_INVALID_INDEX ? 0 : block_property(program, index, GL_BUFFER_DATA_SIZE);
}

std::vector<std::string> active_uniforms(const Program& program) {
  GLint count = 0;
  glGetProgramInterfaceiv(program.id(), GL_UNIFORM, GL_ACTIVE_RESOURCES, &count);
  std::vector<std::string> names;
  for (GLint i = 0; i < count; ++i) {
    constexpr std::array<GLenum, 2> kProperties = {GL_NAME_LENGTH, GL_BLOCK_INDEX};
    std::array<GLint, 2> values{};
    const auto id = static_cast<GLuint>(i);
    glGetProgramResourceiv(program.id(), GL_UNIFORM, id, 2, kProperties.data(), 2, nullptr, values.data());
    if (values[1] == -1) names.push_back(resource_name(program.id(), GL_UNIFORM, id, values[0]));
  }
  return names;
}

}  // namespace umbrameter
