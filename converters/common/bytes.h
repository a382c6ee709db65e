#pragma once
/// Bytes from a file, unpacked on the way.

#include <burin/base/run_context.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace burin {

class Bytes {
 public:
  Bytes() = default;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  virtual ~Bytes() = default;
  /// Up to `n`; less at the end only.
  virtual std::size_t read(char* out, std::size_t n) = 0;
  /// No more than so many bytes can be left: what deflate packs into one is 1032 at most.
  virtual double most_left() const = 0;
};

bool is_gzip(std::string_view bytes);

std::unique_ptr<Bytes> plain_bytes(std::string_view bytes);
/// gzip (of several members too) or zlib; damage throws InputError with `file`. Polls `context`.
std::unique_ptr<Bytes> unpacked_bytes(std::string_view packed, const std::string& file,
                                      const RunContext& context);

/// Whether so many bytes out of so few are far more than models ever pack: a mesh as text packs 5
/// to 20 to 1, a run of equal bytes 1000 to 1. What is small is harmless all the same.
bool is_bomb(double packed, double unpacked);
/// The most bytes that are unpacked in one go, of what packs so well: `is_bomb` beyond.
std::size_t most_unpacked(std::size_t packed);

/// What comes out of `in`, `most` bytes at most.
std::string take(Bytes& in, std::size_t most, const RunContext& context);

}  // namespace burin
