#pragma once
/// The header of a PLY file: which elements with which properties follow it, and how.

#include "source.h"

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace burin {

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;  // in lower case
  PlyType type = PlyType::Float;
  bool is_list = false;
  PlyType count_type = PlyType::UInt8;
};

struct PlyElement {
  std::string name;  // in lower case
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes that one element takes in a binary file, its lists empty.
  std::size_t least_bytes() const;
};

struct PlyHeader {
  bool ascii = false;
  std::endian order = std::endian::little;
  std::vector<PlyElement> elements;
  /// Where the data begin.
  std::size_t data = 0;
};

PlyHeader read_ply_header(const Source& source);

}  // namespace burin
