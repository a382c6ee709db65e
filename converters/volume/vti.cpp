// VTK image data in XML: one piece; text, base64 or appended data, as it is or in blocks of zlib.
#include "binary.h"
#include "bytes.h"
#include "header_text.h"
#include "layout.h"
#include "text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>

namespace burin::volume {
namespace {

constexpr TypeName kVtiTypes[] = {{"Int8", SampleType::I8},     {"UInt8", SampleType::U8},
                                  {"Int16", SampleType::I16},   {"UInt16", SampleType::U16},
                                  {"Int32", SampleType::I32},   {"UInt32", SampleType::U32},
                                  {"Int64", SampleType::I64},   {"UInt64", SampleType::U64},
                                  {"Float32", SampleType::F32}, {"Float64", SampleType::F64}};

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

class VtiFile {
 public:
  explicit VtiFile(const Head& head) : source_(head.source) {}
  Layout read();

 private:
  void parse();
  void grid(const pugi::xml_node& image);
  void report_others(const pugi::xml_node& data, const pugi::xml_node& shown, bool unnamed);
  pugi::xml_node scalars(const pugi::xml_node& piece);
  void array(const pugi::xml_node& array);
  void values(const pugi::xml_node& array);
  // Base64 from the beginning of `text` as far as whole groups reach, `most` bytes; takes them off.
  std::string decoded(std::string_view& text, std::size_t most) const;
  // The bytes of an array that begin here, their count before them.
  std::string unpacked(std::string_view text, bool base64) const;
  std::uint64_t word(std::string_view bytes, std::size_t index) const;
  std::vector<double> numbers(const pugi::xml_node& node, const char* key, std::size_t count,
                              const char* otherwise) const;
  [[noreturn]] void fail(const std::string& what) const { source_.fail(what); }
  std::size_t bytes() const {
    return static_cast<std::size_t>(out_.samples()) * bytes_of(out_.type);
  }

  const Source& source_;
  pugi::xml_document document_;
  // Behind the underscore of AppendedData, to the end of the file.
  std::string_view appended_;
  bool appended_base64_ = false;
  bool packed_ = false;
  bool long_words_ = false;
  Layout out_;
};

void VtiFile::parse() {
  // Appended data is no XML: it is taken off, and so is what ends the document behind it.
  std::string_view text = source_.bytes();
  std::string document;
  const std::size_t at = text.find("<AppendedData");
  if (at != std::string_view::npos) {
    const std::size_t end = text.find('>', at);
    const std::size_t begin = text.find('_', std::min(end, text.size()));
    if (begin == std::string_view::npos)
      fail("the appended data has no beginning; it is truncated");
    appended_ = text.substr(begin + 1);
    appended_base64_ = text.substr(at, end - at).find("base64") != std::string_view::npos;
    document = std::string(text.substr(0, at)) + "</VTKFile>";
    text = document;
  }
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
  if (!result) {
    const char* where = source_.bytes().data() +
                        std::min<std::size_t>(static_cast<std::size_t>(result.offset), text.size());
    source_.fail_at_line(where, fmt::format("{}; export it again", result.description()));
  }
}

std::vector<double> VtiFile::numbers(const pugi::xml_node& node, const char* key, std::size_t count,
                                     const char* otherwise) const {
  const Field field{key, node.attribute(key).as_string(otherwise), 0};
  return Fields(source_).numbers(field, count);
}

void VtiFile::grid(const pugi::xml_node& image) {
  const auto whole = numbers(image, "WholeExtent", 6, "");
  const auto origin = numbers(image, "Origin", 3, "0 0 0");
  const auto spacing = numbers(image, "Spacing", 3, "1 1 1");
  const auto turn = numbers(image, "Direction", 9, "1 0 0 0 1 0 0 0 1");
  const pugi::xml_node piece = image.child("Piece");
  if (!piece) fail("holds no Piece; export it again");
  if (piece.next_sibling("Piece")) fail("data in several pieces is not read; save it in one");
  const auto extent = numbers(piece, "Extent", 6, image.attribute("WholeExtent").as_string());
  out_.origin = {origin[0], origin[1], origin[2]};
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = extent[2 * k + 1] - extent[2 * k] + 1;
    if (!(n >= 1 && n < 1e9)) fail("its extent is empty or too large; export it again");
    out_.size[k] = static_cast<std::int64_t>(n);
    const auto i = static_cast<int>(k);
    out_.steps[i] = spacing[k] * Vec3(turn[k], turn[3 + k], turn[6 + k]);
  }
  for (int k = 0; k < 3; ++k)
    out_.origin += extent[2 * static_cast<std::size_t>(k)] * out_.steps[k];
}

/// Of several arrays, none of which the file names as the one to be shown.
void VtiFile::report_others(const pugi::xml_node& data, const pugi::xml_node& shown, bool unnamed) {
  const auto arrays = data.children("DataArray");
  const auto count = std::distance(arrays.begin(), arrays.end());
  if (count < 2 || !unnamed) return;
  out_.diagnostics.add(
      Severity::Warning, "volume.arrays", count - 1,
      fmt::format("of {} arrays the first one, {}, is drawn; save the one to be drawn as Scalars",
                  count, in_quotes(shown.attribute("Name").as_string())));
}

pugi::xml_node VtiFile::scalars(const pugi::xml_node& piece) {
  for (const char* place : {"PointData", "CellData"}) {
    const pugi::xml_node data = piece.child(place);
    const std::string wanted = data.attribute("Scalars").as_string();
    pugi::xml_node found;
    for (const pugi::xml_node node : data.children("DataArray")) {
      if (!found || node.attribute("Name").as_string() == wanted) found = node;
      if (wanted.empty() || node.attribute("Name").as_string() == wanted) break;
    }
    if (!found) continue;
    report_others(data, found, wanted.empty());
    if (std::string_view(place) == "PointData") return found;
    // The middles of the cells.
    for (int k = 0; k < 3; ++k) {
      --out_.size[static_cast<std::size_t>(k)];
      out_.origin += 0.5 * out_.steps[k];
    }
    return found;
  }
  fail("holds no data at points or cells; export it with its scalars");
}

std::uint64_t VtiFile::word(std::string_view bytes, std::size_t index) const {
  const std::size_t each = long_words_ ? 8 : 4;
  if (bytes.size() < (index + 1) * each) fail("its data ends too early; it is truncated");
  const char* p = bytes.data() + index * each;
  return long_words_ ? load<std::uint64_t>(p, out_.order) : load<std::uint32_t>(p, out_.order);
}

std::string VtiFile::decoded(std::string_view& text, std::size_t most) const {
  std::string out;
  while (out.size() < most) {
    std::uint32_t bits = 0;
    int digits = 0, pads = 0;
    while (digits + pads < 4 && !text.empty()) {
      const char c = text.front();
      if (c == '<') break;
      text.remove_prefix(1);
      if (is_blank(c) || is_line_end(c)) continue;
      const int d = base64_digit(c);
      if (d < 0 && c != '=') fail("its data is no base64; it is damaged");
      bits = bits << 6 | static_cast<std::uint32_t>(std::max(d, 0));
      (d < 0 ? pads : digits) += 1;
    }
    if (digits + pads < 4) break;
    for (int k = 0; k < 3 - pads; ++k) out += static_cast<char>(bits >> (16 - 8 * k) & 0xff);
    if (pads > 0) break;
  }
  return out;
}

std::string VtiFile::unpacked(std::string_view text, bool base64) const {
  const std::size_t each = long_words_ ? 8 : 4;
  const RunContext& context = source_.context();
  if (!packed_) {
    std::string all = base64 ? decoded(text, each + bytes()) : std::string();
    const std::string_view raw = base64 ? std::string_view(all) : text;
    if (word(raw, 0) != bytes())
      fail("the size of its data is not the one that its extent gives; export it again");
    return std::string(raw.substr(each, bytes()));
  }
  // How many blocks, their size, the size of the last, the packed size of each.
  std::string_view ahead = text;
  const std::string first =
      base64 ? decoded(ahead, 3 * each) : std::string(text.substr(0, 3 * each));
  const std::uint64_t blocks = word(first, 0);
  if (blocks > text.size()) fail("its blocks of data are damaged; export it again");
  const std::size_t header = (3 + static_cast<std::size_t>(blocks)) * each;
  // The header is padded as a whole.
  const std::string sizes =
      base64 ? decoded(text, (header + 2) / 3 * 3) : std::string(text.substr(0, header));
  if (!base64) text.remove_prefix(std::min(header, text.size()));
  std::string out, packed;
  std::size_t all = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::uint64_t size = word(sizes, 3 + i);
    if (size > text.size()) fail("its data ends too early; it is truncated");
    all += static_cast<std::size_t>(size);
  }
  if (base64) packed = decoded(text, all);
  std::string_view rest = base64 ? std::string_view(packed) : text;
  for (std::size_t i = 0; i < blocks; ++i) {
    const auto size = static_cast<std::size_t>(word(sizes, 3 + i));
    if (size > rest.size()) fail("its data ends too early; it is truncated");
    const auto in = unpacked_bytes(rest.substr(0, size), source_.file(), context);
    out += take(*in, bytes() - out.size(), context);
    rest.remove_prefix(size);
  }
  if (out.size() != bytes())
    fail("the size of its data is not the one that its extent gives; export it again");
  return out;
}

void VtiFile::values(const pugi::xml_node& array) {
  const std::string format = array.attribute("format").as_string("ascii");
  // What the file can hold at most, packed a thousandfold, before anything is taken out of it.
  const double most = static_cast<double>(source_.bytes().size()) * (packed_ ? 1032 : 2);
  if (out_.samples() * (format == "ascii" ? 1 : static_cast<double>(bytes_of(out_.type))) > most) {
    fail(fmt::format("{} x {} x {} samples cannot be in it; it is truncated, or its extent wrong",
                     out_.size[0], out_.size[1], out_.size[2]));
  }
  if (format == "ascii") {
    out_.encoding = Encoding::Text;
    out_.payload = array.child_value();
  } else if (format == "binary") {
    out_.payload = unpacked(array.child_value(), true);
  } else if (format == "appended") {
    const auto offset = static_cast<std::size_t>(array.attribute("offset").as_ullong());
    if (offset >= appended_.size()) fail("its appended data ends too early; it is truncated");
    out_.payload = unpacked(appended_.substr(offset), appended_base64_);
  } else {
    fail(fmt::format("the format {} of its data is not read", in_quotes(format)));
  }
}

void VtiFile::array(const pugi::xml_node& array) {
  const std::string_view type = array.attribute("type").as_string();
  const auto* it = std::ranges::find(kVtiTypes, type, &TypeName::name);
  if (it == std::end(kVtiTypes)) {
    fail(fmt::format("{} is no type of samples that is read", in_quotes(type)));
  }
  out_.type = it->type;
  if (array.attribute("NumberOfComponents").as_int(1) != 1) {
    fail("vectors and colours are not drawn; save one volume of scalars");
  }
}

Layout VtiFile::read() {
  out_.format = "VTK image data";
  parse();
  const pugi::xml_node file = document_.child("VTKFile");
  const std::string_view kind = file.attribute("type").as_string();
  if (kind != "ImageData") fail(fmt::format("holds {}, no ImageData", in_quotes(kind)));
  const std::string_view compressor = file.attribute("compressor").as_string();
  packed_ = !compressor.empty();
  if (packed_ && compressor != "vtkZLibDataCompressor") {
    fail(fmt::format("the compression {} is not read; save it with zlib", in_quotes(compressor)));
  }
  const bool big = std::string_view(file.attribute("byte_order").as_string()) == "BigEndian";
  out_.order = big ? std::endian::big : std::endian::little;
  long_words_ = std::string_view(file.attribute("header_type").as_string()) == "UInt64";
  const pugi::xml_node image = file.child("ImageData");
  grid(image);
  const pugi::xml_node node = scalars(image.child("Piece"));
  array(node);
  check_layout(out_, source_.file());
  values(node);
  return std::move(out_);
}

}  // namespace

Layout read_vti(const Head& head) { return VtiFile(head).read(); }

}  // namespace burin::volume
