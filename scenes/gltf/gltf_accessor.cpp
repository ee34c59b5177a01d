// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_accessor.h"

#include "core/error.h"
#include "scenes/gltf/tinygltf.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace umbrameter {
namespace {

constexpr size_t kMostElements = size_t{1} << 32;
constexpr size_t kMostSparseElements = size_t{1} << 26;  // of an accessor that may have no bytes behind it

/// Where elements stand.
struct Elements {
  const unsigned char* first = nullptr;
  size_t count = 0;
  size_t stride = 0;
  int component_type = 0;
  int components = 0;
  bool is_normalized = false;
};

/// Where a part of the file says that elements stand.
struct Layout {
  int buffer_view = -1;
  size_t byte_offset = 0;
  size_t count = 0;
  int component_type = 0;
  int components = 0;
  bool is_normalized = false;
  int stride = 0;  // 0: tightly packed
};

class AccessorReader {
 public:
  AccessorReader(const GltfFile& file, int index, const std::string& what)
      : file_(file), model_(*file.model), index_(index), what_(what) {
    if (index < 0 || static_cast<size_t>(index) >= model_.accessors.size()) refuse("does not exist");
    accessor_ = &model_.accessors[static_cast<size_t>(index)];
  }

  [[noreturn]] void refuse(const std::string& why) const {
    fail_input(fmt::format("accessor {} ({}) {}", index_, what_, why), {file_.path.string()});
  }

  const tinygltf::Accessor& accessor() const { return *accessor_; }

  int components() const {
    const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor_->type));
    if (components <= 0) refuse("has a type that is not read");
    return components;
  }

  Elements elements() const {
    Layout layout = {accessor_->bufferView,    accessor_->byteOffset, accessor_->count,
                     accessor_->componentType, components(),          accessor_->normalized};
    layout.stride = accessor_->ByteStride(view_of(layout.buffer_view));
    if (layout.stride <= 0) refuse("has a type that is not read");
    return find(layout);
  }

  Elements sparse_indices() const {
    const auto& indices = accessor_->sparse.indices;
    return find(
        {indices.bufferView, offset_of(indices.byteOffset), sparse_count(), indices.componentType, 1});
  }

  Elements sparse_values() const {
    const auto& values = accessor_->sparse.values;
    return find({values.bufferView, offset_of(values.byteOffset), sparse_count(), accessor_->componentType,
                 components(), accessor_->normalized});
  }

 private:
  size_t offset_of(int bytes) const {
    if (bytes < 0) refuse("has a negative offset");
    return static_cast<size_t>(bytes);
  }

  size_t sparse_count() const {
    const int count = accessor_->sparse.count;
    if (count < 0 || static_cast<size_t>(count) > accessor_->count) refuse("replaces more than it has");
    return static_cast<size_t>(count);
  }

  const tinygltf::BufferView& view_of(int view) const {
    if (view < 0 || static_cast<size_t>(view) >= model_.bufferViews.size()) refuse("has no buffer view");
    return model_.bufferViews[static_cast<size_t>(view)];
  }

  Elements find(const Layout& layout) const {
    const tinygltf::BufferView& view = view_of(layout.buffer_view);
    if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= model_.buffers.size()) refuse("has no buffer");
    const std::vector<unsigned char>& bytes = model_.buffers[static_cast<size_t>(view.buffer)].data;
    const int component_bytes =
        tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(layout.component_type));
    if (component_bytes <= 0) refuse("has a type that is not read");
    const size_t element = static_cast<size_t>(layout.components) * static_cast<size_t>(component_bytes);
    const size_t stride = layout.stride > 0 ? static_cast<size_t>(layout.stride) : element;
    const size_t start = view.byteOffset + layout.byte_offset;
    const size_t view_end = view.byteOffset + view.byteLength;
    const bool overflows = layout.count > kMostElements || start > bytes.size() || view_end > bytes.size();
    if (overflows || (layout.count > 0 && start + (layout.count - 1) * stride + element > view_end))
      refuse(fmt::format("wants {} elements, more than its buffer holds", layout.count));
    return {bytes.data() + start,  layout.count,      stride,
            layout.component_type, layout.components, layout.is_normalized};
  }

  const GltfFile& file_;
  const tinygltf::Model& model_;
  int index_;
  const std::string& what_;
  const tinygltf::Accessor* accessor_ = nullptr;
};

template <class T>
double component(const unsigned char* at, bool is_normalized) {
  T value{};
  std::memcpy(&value, at, sizeof value);
  if constexpr (std::is_floating_point_v<T>) return static_cast<double>(value);
  const auto number = static_cast<double>(value);
  return is_normalized ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
}

double component_at(const Elements& elements, const unsigned char* element, int i) {
  const auto at = [&]<class T>(T) {
    return component<T>(element + static_cast<size_t>(i) * sizeof(T), elements.is_normalized);
  };
  switch (elements.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return at(int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return at(uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return at(int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return at(uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return at(uint32_t{});
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
      return at(double{});
    default:
      return at(float{});
  }
}

/// Element `i` of `elements` to element `to` of `numbers`.
void copy_element(const Elements& elements, size_t i, size_t to, GltfNumbers& numbers) {
  const unsigned char* element = elements.first + i * elements.stride;
  const auto components = static_cast<size_t>(numbers.components);
  for (size_t c = 0; c < components; ++c)
    numbers.values[to * components + c] = component_at(elements, element, static_cast<int>(c));
}

void fill_sparse(const AccessorReader& reader, GltfNumbers& numbers) {
  const Elements indices = reader.sparse_indices(), values = reader.sparse_values();
  for (size_t i = 0; i < indices.count; ++i) {
    const double index = component_at(indices, indices.first + i * indices.stride, 0);
    if (!(index >= 0.0 && index < static_cast<double>(numbers.count)))
      reader.refuse(fmt::format("replaces element {}, but has {}", index, numbers.count));
    copy_element(values, i, static_cast<size_t>(index), numbers);
  }
}

}  // namespace

GltfNumbers read_gltf_numbers(const GltfFile& file, int accessor, const std::string& what) {
  const AccessorReader reader(file, accessor, what);
  const bool is_sparse = reader.accessor().sparse.isSparse;
  GltfNumbers numbers;
  numbers.count = reader.accessor().count;
  numbers.components = reader.components();
  const auto resize = [&] { numbers.values.resize(numbers.count * static_cast<size_t>(numbers.components)); };
  if (is_sparse && numbers.count > kMostSparseElements)
    reader.refuse(fmt::format("wants {} elements, more than {}", numbers.count, kMostSparseElements));
  if (!is_sparse || reader.accessor().bufferView >= 0) {  // else zeros
    const Elements elements = reader.elements();
    resize();
    for (size_t i = 0; i < elements.count; ++i) copy_element(elements, i, i, numbers);
  }
  resize();
  if (is_sparse) fill_sparse(reader, numbers);
  return numbers;
}

std::vector<glm::dvec4> read_gltf_vectors(const GltfFile& file, int accessor, const std::string& what) {
  const GltfNumbers numbers = read_gltf_numbers(file, accessor, what);
  if (numbers.components > 4)
    fail_input(fmt::format("accessor {} ({}) has a type that is not read", accessor, what),
               {file.path.string()});
  std::vector<glm::dvec4> vectors(numbers.count, glm::dvec4(0.0));
  const double* value = numbers.values.data();
  for (glm::dvec4& vector : vectors) {
    for (int c = 0; c < numbers.components; ++c) vector[c] = *value++;
  }
  return vectors;
}

std::vector<uint32_t> read_gltf_indices(const GltfFile& file, int accessor) {
  const GltfNumbers numbers = read_gltf_numbers(file, accessor, "indices");
  const int type = file.model->accessors[static_cast<size_t>(accessor)].componentType;
  const bool is_whole = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                        type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                        type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!is_whole || numbers.components != 1)
    fail_input(fmt::format("accessor {} holds no indices", accessor), {file.path.string()});
  std::vector<uint32_t> indices;
  indices.reserve(numbers.count);
  for (const double value : numbers.values) indices.push_back(static_cast<uint32_t>(value));
  return indices;
}

}  // namespace umbrameter
