#pragma once
/// The objects of a PDF file, written one after the other.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Of paper mm, and of units of a font.
inline constexpr int kPdfDecimals = 3;

/// "/Name" with what names cannot hold as #xx.
std::string pdf_name(std::string_view text);
/// UTF-16, its first byte first, as hexadecimal digits.
std::string utf16_hex(std::string_view utf8);
/// A string in UTF-16 as <hex>.
std::string pdf_text(std::string_view utf8);

/// Numbers of objects are given before what they hold is known. The same calls write the same
/// bytes. @cite PDF17
class PdfObjects {
 public:
  explicit PdfObjects(std::ostream& out);

  /// The number of an object that is still to be written.
  std::size_t reserve();
  void write(std::size_t number, std::string_view dictionary);
  /// A stream, compressed. Throws Error where zlib fails.
  void write_stream(std::size_t number, std::string_view data);
  /// The table of objects and the end.
  void finish(std::size_t catalog, std::size_t info);

 private:
  void put(std::string_view text);

  std::ostream& out_;
  std::uint64_t at_ = 0;
  std::vector<std::uint64_t> places_;
};

}  // namespace burin
