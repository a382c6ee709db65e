#include "bytes.h"

#include <burin/base/error.h>

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

namespace burin {
namespace {

// Between two polls for cancellation.
constexpr std::size_t kPiece = std::size_t{1} << 20;

class Plain final : public Bytes {
 public:
  explicit Plain(std::string_view bytes) : bytes_(bytes) {}

  std::size_t read(char* out, std::size_t n) override {
    n = std::min(n, bytes_.size());
    if (n > 0) std::memcpy(out, bytes_.data(), n);
    bytes_.remove_prefix(n);
    return n;
  }
  double most_left() const override { return static_cast<double>(bytes_.size()); }

 private:
  std::string_view bytes_;
};

class Unpacked final : public Bytes {
 public:
  Unpacked(std::string_view packed, std::string file, const RunContext& context)
      : packed_(packed), file_(std::move(file)), context_(context) {
    constexpr int kGzipOrZlib = 15 + 32;
    if (inflateInit2(&stream_, kGzipOrZlib) != Z_OK) throw std::bad_alloc();
  }
  ~Unpacked() override { inflateEnd(&stream_); }

  std::size_t read(char* out, std::size_t n) override;
  double most_left() const override {
    constexpr double kMostRatio = 1032;
    return kMostRatio * static_cast<double>(packed_.size() - used_) + kMostRatio;
  }

 private:
  // One call of zlib; false at the end of the data.
  bool step(char* out, std::size_t n, std::size_t& got);
  [[noreturn]] void fail(const char* why) const {
    throw InputError(
        fmt::format("at byte {} of the compressed data: {}; copy or export it again", used_, why),
        file_);
  }

  std::string_view packed_;
  std::size_t used_ = 0;
  std::string file_;
  const RunContext& context_;
  z_stream stream_{};
  bool ended_ = false;
};

bool Unpacked::step(char* out, std::size_t n, std::size_t& got) {
  const std::size_t in = std::min(kPiece, packed_.size() - used_);
  // zlib does not write to its input.
  stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data() + used_));
  stream_.avail_in = static_cast<uInt>(in);
  stream_.next_out = reinterpret_cast<Bytef*>(out);
  stream_.avail_out = static_cast<uInt>(std::min(n, kPiece));
  const uInt room = stream_.avail_out;
  const int status = inflate(&stream_, Z_NO_FLUSH);
  used_ += in - stream_.avail_in;
  got = room - stream_.avail_out;
  if (status == Z_STREAM_END) {
    // Another member may follow; anything else behind the data is none of ours.
    if (is_gzip(packed_.substr(used_))) {
      if (inflateReset(&stream_) != Z_OK) fail("it cannot be unpacked");
      return true;
    }
    return false;
  }
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status == Z_BUF_ERROR || (status == Z_OK && got == 0 && used_ == packed_.size())) {
    fail("it ends too early, the file is truncated");
  }
  if (status != Z_OK) fail("it is damaged");
  return true;
}

std::size_t Unpacked::read(char* out, std::size_t n) {
  std::size_t done = 0;
  while (done < n && !ended_) {
    context_.check();
    std::size_t got = 0;
    ended_ = !step(out + done, n - done, got);
    done += got;
  }
  return done;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

namespace {

constexpr double kLargestRatio = 200;
constexpr double kHarmless = 16 << 20;  // bytes

}  // namespace

bool is_bomb(double packed, double unpacked) {
  return unpacked > kHarmless && unpacked / (packed + 1) > kLargestRatio;
}

std::size_t most_unpacked(std::size_t packed) {
  return static_cast<std::size_t>(
      std::max(kHarmless, kLargestRatio * (static_cast<double>(packed) + 1)));
}

std::unique_ptr<Bytes> plain_bytes(std::string_view bytes) {
  return std::make_unique<Plain>(bytes);
}

std::unique_ptr<Bytes> unpacked_bytes(std::string_view packed, const std::string& file,
                                      const RunContext& context) {
  return std::make_unique<Unpacked>(packed, file, context);
}

std::string take(Bytes& in, std::size_t most, const RunContext& context) {
  std::string out;
  while (out.size() < most) {
    context.check();
    const std::size_t had = out.size();
    out.resize(had + std::min(kPiece, most - had));
    const std::size_t got = in.read(out.data() + had, out.size() - had);
    out.resize(had + got);
    if (got == 0) break;
  }
  return out;
}

}  // namespace burin
