#include "accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace burin::gltf {
namespace {

template <class T>
double loaded(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

/// glTF is little-endian, as the machines are that Burin runs on.
double number(const unsigned char* at, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return loaded<std::int8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return loaded<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return loaded<std::int16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return loaded<std::uint16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return loaded<std::uint32_t>(at);
    default:
      return loaded<float>(at);
  }
}

/// The value that is 1 when it is normalised; 1 for those that are not.
double full(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535;
    default:
      return 1;
  }
}

/// Bytes of a number; 0: it is of a type that glTF does not have.
std::size_t size_of(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

/// Numbers of a row; 0: no type of glTF.
std::size_t width_of(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;
  }
}

}  // namespace

Accessors::Accessors(const tinygltf::Model& model, const Source& source)
    : model_(model), source_(source) {
  for (const tinygltf::Buffer& buffer : model.buffers) bytes_ += buffer.data.size();
}

void Accessors::fail(int accessor, const char* what) const {
  source_.fail(fmt::format(
      "accessor {} of the glTF {}; it is damaged or truncated, export it again", accessor, what));
}

Accessors::View Accessors::view(int accessor, int view, std::size_t offset, std::size_t count,
                                std::size_t bytes, bool packed) const {
  if (view < 0 || static_cast<std::size_t>(view) >= model_.bufferViews.size()) {
    fail(accessor, "refers to a buffer view that is not there");
  }
  const tinygltf::BufferView& of = model_.bufferViews[static_cast<std::size_t>(view)];
  if (of.buffer < 0 || static_cast<std::size_t>(of.buffer) >= model_.buffers.size()) {
    fail(accessor, "lies in a buffer that is not there");
  }
  const auto& data = model_.buffers[static_cast<std::size_t>(of.buffer)].data;
  const std::size_t stride = of.byteStride == 0 || packed ? bytes : of.byteStride;
  if (stride < bytes) fail(accessor, "has elements that overlap");
  const bool inside = of.byteOffset <= data.size() && of.byteLength <= data.size() - of.byteOffset;
  if (!inside || offset > of.byteLength || bytes > of.byteLength - offset ||
      (count - 1) > (of.byteLength - offset - bytes) / stride) {
    fail(accessor, "claims more than its buffer holds");
  }
  return {data.data() + of.byteOffset + offset, stride};
}

/// Puts the values of a sparse accessor in their places.
void Accessors::overlay(int accessor, Rows& rows) const {
  const tinygltf::Accessor& a = model_.accessors[static_cast<std::size_t>(accessor)];
  if (!a.sparse.isSparse || a.sparse.count <= 0) return;
  const auto count = static_cast<std::size_t>(a.sparse.count);
  const auto offset = [](int bytes) { return static_cast<std::size_t>(std::max(bytes, 0)); };
  const std::size_t index_bytes = size_of(a.sparse.indices.componentType);
  const std::size_t value_bytes = size_of(a.componentType) * rows.width;
  if (index_bytes == 0) fail(accessor, "has indices of an unknown type");
  const View places = view(accessor, a.sparse.indices.bufferView,
                           offset(a.sparse.indices.byteOffset), count, index_bytes, true);
  const View values = view(accessor, a.sparse.values.bufferView, offset(a.sparse.values.byteOffset),
                           count, value_bytes, true);
  const double unit = a.normalized ? 1 / full(a.componentType) : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = number(places.begin + i * places.stride, a.sparse.indices.componentType);
    if (!(place >= 0 && place < static_cast<double>(rows.count()))) {
      fail(accessor, "has sparse values for elements that it does not have");
    }
    for (std::size_t k = 0; k < rows.width; ++k) {
      const unsigned char* at = values.begin + i * values.stride + k * size_of(a.componentType);
      rows.values[static_cast<std::size_t>(place) * rows.width + k] =
          unit * number(at, a.componentType);
    }
  }
}

Rows Accessors::read(int accessor) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size()) {
    fail(accessor, "is referred to and not there");
  }
  const tinygltf::Accessor& a = model_.accessors[static_cast<std::size_t>(accessor)];
  const std::size_t size = size_of(a.componentType);
  Rows rows{.width = width_of(a.type)};
  if (size == 0 || rows.width == 0) fail(accessor, "is of a type that is not read");
  if (a.count == 0) return rows;
  if (a.count > bytes_ / rows.width) fail(accessor, "claims more than the file holds");
  rows.values.resize(a.count * rows.width);  // those of no buffer view are 0
  if (a.bufferView >= 0) {
    const View in = view(accessor, a.bufferView, a.byteOffset, a.count, size * rows.width, false);
    const double unit = a.normalized ? 1 / full(a.componentType) : 1;
    double* out = rows.values.data();
    for (std::size_t i = 0; i < a.count; ++i) {
      source_.context().check();
      for (std::size_t k = 0; k < rows.width; ++k) {
        *out++ = unit * number(in.begin + i * in.stride + k * size, a.componentType);
      }
    }
  }
  overlay(accessor, rows);
  return rows;
}

Rows Accessors::read(int accessor, std::size_t width) const {
  Rows rows = read(accessor);
  if (rows.width != width) fail(accessor, "is of another type than it is used as");
  return rows;
}

std::vector<std::uint32_t> Accessors::indices(int accessor) const {
  const Rows rows = read(accessor, 1);
  std::vector<std::uint32_t> out;
  out.reserve(rows.values.size());
  for (const double v : rows.values) {
    if (!(v >= 0 && v <= 4294967295.0)) fail(accessor, "has an index that is none");
    out.push_back(static_cast<std::uint32_t>(v));
  }
  return out;
}

}  // namespace burin::gltf
