#pragma once
// Numbers out of the buffers of a glTF; internal to the module.

#include <burin/base/vec.h>

#include "source.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <vector>

namespace burin::gltf {

/// Rows of numbers, each `width` of them.
struct Rows {
  std::size_t width = 0;
  std::vector<double> values = {};

  std::size_t count() const { return width == 0 ? 0 : values.size() / width; }
  double at(std::size_t row, std::size_t column) const { return values[row * width + column]; }
  Vec3 point(std::size_t row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }
};

/// Reads accessors: of any type of number, normalised, strided, sparse. What they claim is compared
/// with the bytes that there are before anything is allocated; throws InputError.
class Accessors {
 public:
  Accessors(const tinygltf::Model& model, const Source& source);

  Rows read(int accessor) const;
  /// The same where rows have to be so wide.
  Rows read(int accessor, std::size_t width) const;
  /// Whole numbers: the corners of triangles.
  std::vector<std::uint32_t> indices(int accessor) const;

 private:
  struct View {
    const unsigned char* begin;
    std::size_t stride;
  };

  [[noreturn]] void fail(int accessor, const char* what) const;
  /// `count` elements of `bytes` each, from `offset` of a view on.
  View view(int accessor, int view, std::size_t offset, std::size_t count, std::size_t bytes,
            bool packed) const;
  void overlay(int accessor, Rows& rows) const;

  const tinygltf::Model& model_;
  const Source& source_;
  std::size_t bytes_ = 0;
};

}  // namespace burin::gltf
