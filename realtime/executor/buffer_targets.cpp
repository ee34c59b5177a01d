// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/buffer_targets.h"

#include "realtime/manifest/names.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace umbrameter {
namespace {

constexpr size_t kMostComponents = 4;  // of what GL clears with, and of a pixel

/// A number's bits as an element holds them.
uint32_t bits_of(double value, ElementScalar scalar) {
  switch (scalar) {
    case ElementScalar::real:
      return std::bit_cast<uint32_t>(static_cast<float>(value));
    case ElementScalar::integer:
      return std::bit_cast<uint32_t>(static_cast<int32_t>(value));
    case ElementScalar::unsigned_integer:
      return static_cast<uint32_t>(value);
  }
  return 0;
}

float float_of(uint32_t bits, ElementScalar scalar) {
  switch (scalar) {
    case ElementScalar::real:
      return std::bit_cast<float>(bits);
    case ElementScalar::integer:
      return static_cast<float>(std::bit_cast<int32_t>(bits));
    case ElementScalar::unsigned_integer:
      return static_cast<float>(bits);
  }
  return 0.0f;
}

size_t pixel_components(const ElementType& element) {
  return std::min(static_cast<size_t>(element.components), kMostComponents);
}

int64_t most_elements(const ElementType& element) {
  GLint bytes = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  return static_cast<int64_t>(bytes) / static_cast<int64_t>(element.bytes());
}

}  // namespace

BufferTargets::BufferTargets(const RunInputs& inputs, const ExpressionVariables& variables) {
  const std::set<std::string> previously = read_previously(inputs.technique.passes);
  for (const BufferDeclaration& declaration : inputs.technique.buffers) {
    if (!holds(declaration.condition, variables)) continue;
    add(declaration, declaration.name, variables);
    if (previously.contains(declaration.name))
      add(declaration, std::string(kPrevious) + declaration.name, variables);
  }
}

void BufferTargets::add(const BufferDeclaration& declaration, const std::string& name,
                        const ExpressionVariables& variables) {
  const auto count = whole_number(declaration.count, variables, 1, most_elements(*declaration.element),
                                  fmt::format("count of buffer '{}'", declaration.name));
  targets_[name] = {declaration.element, static_cast<size_t>(count), nullptr};
}

const BufferTarget* BufferTargets::find(const std::string& name) const {
  const auto found = targets_.find(name);
  return found == targets_.end() ? nullptr : &found->second;
}

size_t BufferTargets::bytes() const {
  size_t sum = 0;
  for (const auto& [name, target] : targets_) sum += target.bytes();
  return sum;
}

void BufferTargets::allocate(const std::string& name) {
  const auto found = targets_.find(name);
  if (found == targets_.end() || found->second.buffer != nullptr) return;
  found->second.buffer = std::make_shared<const Buffer>(found->second.bytes(), nullptr);
  label_object(GL_BUFFER, found->second.buffer->id(), name);
}

void BufferTargets::replace(const std::string& name, std::shared_ptr<const Buffer> buffer) {
  targets_.at(name).buffer = std::move(buffer);
}

void clear_buffer(const BufferTarget& target, std::span<const double> values) {
  UMBRAMETER_ASSERT(!values.empty(), "{} values to clear with", values.size());
  std::array<uint32_t, kMostComponents> pattern{};
  for (size_t k = 0; k < pattern.size(); ++k)
    pattern[k] = bits_of(values[std::min(k, values.size() - 1)], target.element->scalar);
  // Bits are bits: the clear copies words, whatever they mean.
  struct Words {
    GLenum internal_format, format;
  };
  constexpr std::array<Words, 5> kWords = {
      {{}, {GL_R32UI, GL_RED_INTEGER}, {GL_RG32UI, GL_RG_INTEGER}, {}, {GL_RGBA32UI, GL_RGBA_INTEGER}}};
  const Words& words = kWords.at(pixel_components(*target.element));
  glClearNamedBufferData(target.buffer->id(), words.internal_format, words.format, GL_UNSIGNED_INT,
                         pattern.data());
}

Image read_elements(const BufferTarget& target) {
  std::vector<uint32_t> words(target.bytes() / sizeof(uint32_t));
  glGetNamedBufferSubData(target.buffer->id(), 0, static_cast<GLsizeiptr>(target.bytes()), words.data());
  const size_t components = pixel_components(*target.element);
  Image image(static_cast<int>(words.size() / components), 1);
  for (size_t component = 0; component < components; ++component) {
    const auto plane = image.add_plane(components == 1 ? "Y" : std::string(1, "RGBA"[component]));
    for (size_t i = 0; i < plane.size(); ++i)
      plane[i] = float_of(words[i * components + component], target.element->scalar);
  }
  return image;
}

}  // namespace umbrameter
