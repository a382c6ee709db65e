#include "ply_header.h"

#include <burin/base/nearest.h>

#include "text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {{
    {"char", PlyType::Int8},
    {"uchar", PlyType::UInt8},
    {"short", PlyType::Int16},
    {"ushort", PlyType::UInt16},
    {"int", PlyType::Int32},
    {"uint", PlyType::UInt32},
    {"float", PlyType::Float},
    {"double", PlyType::Double},
    {"int8", PlyType::Int8},
    {"uint8", PlyType::UInt8},
    {"int16", PlyType::Int16},
    {"uint16", PlyType::UInt16},
    {"int32", PlyType::Int32},
    {"uint32", PlyType::UInt32},
    {"float32", PlyType::Float},
    {"float64", PlyType::Double},
}};

class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source), text_(source) {}
  PlyHeader read();

 private:
  std::string word(const char* what);
  PlyType type();
  void format();
  void element();
  void property();

  std::size_t end_of_line() const;

  const Source& source_;
  TextCursor text_;
  PlyHeader header_;
};

std::string HeaderReader::word(const char* what) {
  text_.skip_blanks();
  if (text_.at_line_end())
    text_.fail(std::string("the line of the PLY header ends where ") + what + " should be");
  return lowered(text_.token());
}

PlyType HeaderReader::type() {
  const std::string name = word("a type");
  const auto found =
      std::ranges::find(kTypes, std::string_view(name), [](const auto& t) { return t.first; });
  if (found == kTypes.end()) text_.fail(in_quotes(name) + " is no type of a PLY property");
  return found->second;
}

void HeaderReader::format() {
  const std::string name = word("the format");
  if (name == "ascii") {
    header_.ascii = true;
  } else if (name == "binary_big_endian") {
    header_.order = std::endian::big;
  } else if (name != "binary_little_endian") {
    text_.fail(in_quotes(name) +
               " is no PLY format: ascii, binary_little_endian, binary_big_endian");
  }
}

void HeaderReader::element() {
  PlyElement e;
  e.name = word("the name of an element");
  const std::int64_t count = text_.integer("the number of elements");
  if (count < 0) text_.fail("the number of elements is negative");
  e.count = static_cast<std::size_t>(count);
  header_.elements.push_back(std::move(e));
}

void HeaderReader::property() {
  if (header_.elements.empty()) text_.fail("a property comes before the first element");
  PlyProperty p;
  text_.skip_blanks();
  TextCursor ahead = text_;
  p.is_list = lowered(ahead.token()) == "list";
  if (p.is_list) {
    text_.token();
    p.count_type = type();
    if (p.count_type == PlyType::Float || p.count_type == PlyType::Double) {
      text_.fail("the length of a list cannot be a float");
    }
  }
  p.type = type();
  p.name = word("the name of a property");
  header_.elements.back().properties.push_back(std::move(p));
}

/// Programs write remarks without "comment" before them ("Created by Blender3D"); a word that is
/// nearly one of the header's is damaged.
bool is_nearly(const std::string& keyword) {
  constexpr std::size_t kSlips = 2;
  return std::ranges::any_of(
      std::array<std::string_view, 4>{"element", "property", "format", "end_header"},
      [&](std::string_view word) { return edit_distance(keyword, word) <= kSlips; });
}

PlyHeader HeaderReader::read() {
  bool has_format = false;
  text_.next_line();  // "ply"
  for (;;) {
    text_.skip_blanks();
    if (text_.at_end())
      text_.fail("the PLY header ends without 'end_header'; the file is truncated");
    const std::string keyword = text_.at_line_end() ? "comment" : lowered(text_.token());
    if (keyword == "end_header") break;
    if (keyword == "format") {
      format();
      has_format = true;
    } else if (keyword == "element") {
      element();
    } else if (keyword == "property") {
      property();
    } else if (is_nearly(keyword)) {
      text_.fail(in_quotes(keyword) + " is no word of a PLY header");
    }
    text_.next_line();
  }
  if (!has_format) text_.fail("the PLY header states no format; export it again");
  header_.data = end_of_line();
  return std::move(header_);
}

/// Behind the end of this line, which is as that of the first one: after a lone \r the data may
/// begin with a \n.
std::size_t HeaderReader::end_of_line() const {
  const std::string_view bytes = source_.bytes();
  const auto here = static_cast<std::size_t>(text_.where() - bytes.data());
  const std::size_t p = std::min(bytes.find_first_of("\r\n", here), bytes.size());
  const std::size_t width = bytes.substr(3, 2) == "\r\n" && bytes.substr(p, 2) == "\r\n" ? 2 : 1;
  return std::min(bytes.size(), p + width);
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float:
      return 4;
    case PlyType::Double:
      return 8;
  }
  return 0;
}

std::size_t PlyElement::least_bytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& p : properties) bytes += size_of(p.is_list ? p.count_type : p.type);
  return bytes;
}

PlyHeader read_ply_header(const Source& source) { return HeaderReader(source).read(); }

}  // namespace burin
