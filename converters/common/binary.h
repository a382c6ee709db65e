#pragma once
/// Reading numbers of either byte order out of bytes.

#include "source.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace burin {

/// The number whose bytes in `order` begin at `p`.
template <class T>
T load(const char* p, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), p, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// A place in binary data. Ask `has` before each `get`.
class BinaryCursor {
 public:
  BinaryCursor(const Source& source, std::size_t offset, std::endian order)
      : bytes_(source.bytes()), offset_(offset), order_(order) {}

  std::size_t offset() const { return offset_; }
  std::size_t left() const { return bytes_.size() - offset_; }
  /// Whether so many bytes are left; a double, so that products of counts cannot overflow.
  bool has(double bytes) const { return bytes <= static_cast<double>(left()); }
  void skip(std::size_t n) { offset_ += n; }
  const char* data() const { return bytes_.data() + offset_; }
  template <class T>
  T get() {
    const T value = load<T>(data(), order_);
    offset_ += sizeof(T);
    return value;
  }

 private:
  std::string_view bytes_;
  std::size_t offset_;
  std::endian order_;
};

}  // namespace burin
