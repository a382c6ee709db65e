#pragma once
// Bytes from a file, unpacked on the way.

#include <burin/base/run_context.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace burin::volume {

class Bytes {
 public:
  Bytes() = default;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  virtual ~Bytes() = default;
  // Up to `n`; less at the end only.
  virtual std::size_t read(char* out, std::size_t n) = 0;
  // No more than so many bytes can be left: what deflate packs into one is 1032 at most.
  virtual double most_left() const = 0;
};

bool is_gzip(std::string_view bytes);

std::unique_ptr<Bytes> plain_bytes(std::string_view bytes);
// gzip (of several members too) or zlib; damage throws InputError with `file`. Polls `context`.
std::unique_ptr<Bytes> unpacked_bytes(std::string_view packed, const std::string& file,
                                      const RunContext& context);

// What comes out of `in`, `most` bytes at most.
std::string take(Bytes& in, std::size_t most, const RunContext& context);

}  // namespace burin::volume
