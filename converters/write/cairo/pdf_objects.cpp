#include "pdf_objects.h"

#include <burin/base/error.h>
#include <burin/drawing/text.h>

#include <fmt/format.h>
#include <zlib.h>

#include <ostream>

namespace burin {

std::string pdf_name(std::string_view text) {
  constexpr std::string_view kSpecial = "#()<>[]{}/%";
  std::string out = "/";
  for (const char c : text) {
    const bool regular = c > ' ' && c <= '~' && kSpecial.find(c) == std::string_view::npos;
    out += regular ? std::string(1, c) : fmt::format("#{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

std::string utf16_hex(std::string_view utf8) {
  constexpr char32_t kBeyond = 0x10000;
  std::string out;
  for (const char32_t c : code_points(utf8)) {
    if (c < kBeyond) {
      out += fmt::format("{:04X}", static_cast<std::uint32_t>(c));
    } else {
      const std::uint32_t rest = c - kBeyond;
      out += fmt::format("{:04X}{:04X}", 0xD800 + (rest >> 10), 0xDC00 + (rest & 0x3FF));
    }
  }
  return out;
}

std::string pdf_text(std::string_view utf8) { return "<FEFF" + utf16_hex(utf8) + ">"; }

PdfObjects::PdfObjects(std::ostream& out) : out_(out) {
  // Bytes over 127 tell programs that the file is no text.
  put("%PDF-1.4\n%\xB5\xED\xAE\xFB\n");
}

std::size_t PdfObjects::reserve() {
  places_.push_back(0);
  return places_.size();
}

void PdfObjects::write(std::size_t number, std::string_view dictionary) {
  places_[number - 1] = at_;
  put(fmt::format("{} 0 obj\n{}\nendobj\n", number, dictionary));
}

void PdfObjects::write_stream(std::size_t number, std::string_view data) {
  uLongf size = compressBound(static_cast<uLong>(data.size()));
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(data.data()), static_cast<uLong>(data.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw Error("zlib failed to compress a page");
  }
  packed.resize(size);
  write(number,
        fmt::format("<< /Length {} /Filter /FlateDecode >>\nstream\n{}\nendstream", size, packed));
}

void PdfObjects::finish(std::size_t catalog, std::size_t info) {
  const std::uint64_t table = at_;
  put(fmt::format("xref\n0 {}\n0000000000 65535 f \n", places_.size() + 1));
  for (const std::uint64_t place : places_) put(fmt::format("{:010} 00000 n \n", place));
  put(fmt::format("trailer\n<< /Size {} /Root {} 0 R /Info {} 0 R >>\nstartxref\n{}\n%%EOF\n",
                  places_.size() + 1, catalog, info, table));
}

void PdfObjects::put(std::string_view text) {
  out_.write(text.data(), static_cast<std::streamsize>(text.size()));
  at_ += text.size();
}

}  // namespace burin
