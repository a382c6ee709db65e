#include "samples.h"

#include <burin/base/error.h>

#include "binary.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::volume {
namespace {

// Samples between two polls for cancellation.
constexpr std::size_t kPiece = std::size_t{1} << 18;

template <class T>
void convert(const char* raw, std::size_t n, const Layout& layout, float* out) {
  if (layout.slope == 1 && layout.intercept == 0) {
    for (std::size_t i = 0; i < n; ++i) {
      out[i] = static_cast<float>(load<T>(raw + i * sizeof(T), layout.order));
    }
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto value = static_cast<double>(load<T>(raw + i * sizeof(T), layout.order));
    out[i] = static_cast<float>(layout.slope * value + layout.intercept);
  }
}

using Convert = void (*)(const char*, std::size_t, const Layout&, float*);
// In the order of SampleType.
constexpr Convert kConvert[] = {
    convert<std::int8_t>,  convert<std::uint8_t>,  convert<std::int16_t>, convert<std::uint16_t>,
    convert<std::int32_t>, convert<std::uint32_t>, convert<std::int64_t>, convert<std::uint64_t>,
    convert<float>,        convert<double>};

class Loader {
 public:
  Loader(Layout& layout, const Source& file, RunContext& context)
      : layout_(layout), file_(file), context_(context), count_(as_count(layout)) {}

  std::vector<float> load(Bytes& in, const Bytes* of_known_size);
  void skip_lines(Bytes& in);
  void skip(Bytes& in, std::size_t bytes);
  // Whether `left` bytes can hold the samples; throws where they cannot.
  void fits(double left, double bytes_each) const;
  std::vector<float> text(const Source& text) const;
  std::string from_hex(std::string_view text) const;
  std::size_t bytes() const { return count_ * bytes_of(layout_.type); }
  std::size_t count() const { return count_; }

 private:
  static std::size_t as_count(const Layout& layout) {
    return static_cast<std::size_t>(layout.size[0]) * static_cast<std::size_t>(layout.size[1]) *
           static_cast<std::size_t>(layout.size[2]);
  }

  Layout& layout_;
  const Source& file_;
  RunContext& context_;
  std::size_t count_;
};

void Loader::fits(double left, double bytes_each) const {
  const double need = static_cast<double>(count_) * bytes_each;
  if (need <= left) return;
  throw InputError(fmt::format("{} x {} x {} samples of {} need {:.0f} bytes, {:.0f} are there at "
                               "most; the file is truncated, or its header wrong",
                               layout_.size[0], layout_.size[1], layout_.size[2],
                               name_of(layout_.type), need, std::max(left, 0.0)),
                   file_.file(), layout_.size_line);
}

void Loader::skip(Bytes& in, std::size_t bytes) {
  std::string piece(std::min<std::size_t>(bytes, std::size_t{1} << 20), '\0');
  while (bytes > 0) {
    context_.check();
    const std::size_t got = in.read(piece.data(), std::min(bytes, piece.size()));
    if (got == 0) file_.fail("ends before its data begins; it is truncated");
    bytes -= got;
  }
}

void Loader::skip_lines(Bytes& in) {
  for (std::int64_t i = 0; i < layout_.skip_lines; ++i) {
    if (i % 4096 == 0) context_.check();
    for (char c = 0; c != '\n';) {
      if (in.read(&c, 1) == 0) file_.fail("ends before its data begins; it is truncated");
    }
  }
}

std::vector<float> Loader::load(Bytes& in, const Bytes* of_known_size) {
  const std::size_t each = bytes_of(layout_.type);
  std::vector<float> samples(count_);
  std::string piece(kPiece * each, '\0');
  for (std::size_t done = 0; done < count_; done += kPiece) {
    context_.check();
    const std::size_t n = std::min(kPiece, count_ - done);
    const std::size_t got = in.read(piece.data(), n * each);
    if (got < n * each) {
      file_.fail(
          fmt::format("its data ends after {} of {} bytes; it is truncated, or its header "
                      "wrong",
                      done * each + got, bytes()));
    }
    context_.progress(static_cast<double>(done + n) / static_cast<double>(count_));
    kConvert[static_cast<std::size_t>(layout_.type)](piece.data(), n, layout_, &samples[done]);
  }
  if (of_known_size != nullptr && of_known_size->most_left() > 0) {
    layout_.diagnostics.add(Severity::Info, "volume.trailing_bytes",
                            static_cast<std::int64_t>(of_known_size->most_left()),
                            "bytes behind the data were left out");
  }
  return samples;
}

std::vector<float> Loader::text(const Source& text) const {
  std::vector<float> samples(count_);
  TextCursor in(text);
  for (std::size_t i = 0; i < count_; ++i) {
    if (i % 4096 == 0) context_.check();
    in.skip_space();
    const double value = in.number("a sample");
    samples[i] = static_cast<float>(layout_.slope * value + layout_.intercept);
  }
  return samples;
}

std::string Loader::from_hex(std::string_view text) const {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string out;
  int half = -1;
  for (const char c : text) {
    if (is_blank(c) || is_line_end(c)) continue;
    const int d = digit(c);
    if (d < 0) file_.fail(fmt::format("{} is no hexadecimal digit", in_quotes({&c, 1})));
    if (half < 0) {
      half = d;
      continue;
    }
    out += static_cast<char>(half * 16 + d);
    half = -1;
    if (out.size() == bytes()) break;
  }
  return out;
}

// Text and nested compression inside a packed file: longest that one sample can be written.
constexpr std::size_t kLongestText = 40;

}  // namespace

std::vector<float> load_samples(Layout& layout, const Source& file, bool packed,
                                RunContext& context) {
  Loader loader(layout, file, context);
  const auto each = static_cast<double>(bytes_of(layout.type));
  std::string_view bytes =
      layout.payload ? std::string_view(*layout.payload) : std::string_view(file.bytes());
  if (!packed && !layout.payload) {
    bytes.remove_prefix(std::min(layout.header_bytes, bytes.size()));
  }
  std::unique_ptr<Bytes> in =
      packed ? unpacked_bytes(bytes, file.file(), context) : plain_bytes(bytes);
  if (packed) loader.skip(*in, layout.header_bytes);
  loader.skip_lines(*in);
  if (layout.encoding == Encoding::Raw) {
    if (layout.skip_bytes < 0 && packed) {
      file.fail("data at the end of a compressed file is not read; unpack it first");
    }
    const double skip = static_cast<double>(std::max<std::int64_t>(layout.skip_bytes, 0));
    loader.fits(in->most_left() - skip, each);
    loader.skip(*in, layout.skip_bytes < 0
                         ? static_cast<std::size_t>(in->most_left()) - loader.bytes()
                         : static_cast<std::size_t>(layout.skip_bytes));
    return loader.load(*in, packed ? nullptr : in.get());
  }
  // What is left of the file in one piece; a packed one is unpacked as far as samples can reach.
  std::string unpacked;
  if (packed) {
    loader.fits(in->most_left(), layout.encoding == Encoding::Deflate ? 1e-4 : 1);
    unpacked = take(*in, (loader.count() + 1024) * kLongestText, context);
    bytes = unpacked;
  } else {
    bytes.remove_prefix(bytes.size() - static_cast<std::size_t>(in->most_left()));
  }
  if (layout.encoding == Encoding::Deflate) {
    const auto inner = unpacked_bytes(bytes, file.file(), context);
    loader.fits(inner->most_left() - static_cast<double>(layout.skip_bytes), each);
    loader.skip(*inner, static_cast<std::size_t>(layout.skip_bytes));
    return loader.load(*inner, nullptr);
  }
  if (layout.skip_bytes > static_cast<std::int64_t>(bytes.size())) {
    file.fail("ends before its data begins; it is truncated");
  }
  bytes.remove_prefix(static_cast<std::size_t>(layout.skip_bytes));
  if (layout.encoding == Encoding::Hex) {
    loader.fits(static_cast<double>(bytes.size()), 2 * each);
    const std::string raw = loader.from_hex(bytes);
    return loader.load(*plain_bytes(raw), nullptr);
  }
  loader.fits(static_cast<double>(bytes.size()) + 1, 2);
  return loader.text(Source(file.file(), bytes, context));
}

}  // namespace burin::volume
