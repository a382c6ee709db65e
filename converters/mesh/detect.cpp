#include <burin/base/input_name.h>

#include "byte_order_mark.h"
#include "foreign_file.h"
#include "formats.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace burin {
namespace {

const std::map<std::string, MeshFormat>& suffixes() {
  static const std::map<std::string, MeshFormat> table = {
      {".stl", MeshFormat::StlBinary}, {".obj", MeshFormat::Obj},     {".off", MeshFormat::Off},
      {".ply", MeshFormat::Ply},       {".3mf", MeshFormat::ThreeMf}, {".amf", MeshFormat::Amf}};
  return table;
}

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

/// "format": "burin-drawing" stands first in what `burin draw` writes.
bool is_drawing(std::string_view bytes) {
  return starts(bytes, "{") &&
         bytes.substr(0, 256).find("\"burin-drawing\"") != std::string_view::npos;
}

bool is_illustration_text(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 1024);
  return begin.find('{') != std::string_view::npos &&
         begin.find("\"burin\"") != std::string_view::npos;
}

/// Of a file of `size` bytes that begins so.
bool is_exact_binary_stl(std::string_view head, std::uintmax_t size) {
  if (head.size() < 84) return false;
  std::uint32_t n = 0;
  std::memcpy(&n, head.data() + 80, sizeof n);
  return n > 0 && size == 84 + 50 * static_cast<std::uintmax_t>(n);
}

/// What programs leave that did not know the number of triangles when they began.
bool is_binary_stl_of_zero(std::string_view bytes) {
  constexpr std::string_view kZero("\0\0\0\0", 4);
  return bytes.size() > 84 && (bytes.size() - 84) % 50 == 0 && bytes.substr(80, 4) == kZero;
}

/// Whether the file is text of some kind: no text holds a NUL but behind its last line, and hardly
/// a mesh in binary lacks one.
bool is_text(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 1024);
  if (begin.find('\0') == std::string_view::npos) return true;
  const std::string_view text = without_padding(begin);
  return text.find('\0') == std::string_view::npos && text.find_first_of("\r\n") != text.npos;
}

std::string_view without_leading_space(std::string_view text) {
  text.remove_prefix(byte_order_mark(text));
  const std::size_t begin = text.find_first_not_of(" \t\v\f\r\n");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

/// The first lines that are neither empty nor comments look like an OBJ's.
bool looks_like_obj(std::string_view text) {
  static constexpr std::string_view kFirst[] = {"v ", "vn ",     "vt ",     "o ",
                                                "g ", "mtllib ", "usemtl ", "s "};
  while (!text.empty()) {
    text = without_leading_space(text);
    if (!starts(text, "#")) {
      return std::ranges::any_of(kFirst, [&](std::string_view k) { return starts(text, k); });
    }
    const std::size_t end = text.find_first_of("\r\n");
    text = end == std::string_view::npos ? std::string_view() : text.substr(end);
  }
  return false;
}

bool looks_like_off(std::string_view text) {
  text = without_leading_space(text);
  const std::size_t off = text.substr(0, 8).find("OFF");
  return off != std::string_view::npos &&
         text.substr(0, off).find_first_not_of("STCN4n") == std::string_view::npos;
}

/// The element "amf" stands first, behind what XML allows before it.
bool looks_like_amf(std::string_view text) {
  text = without_leading_space(text);
  return starts(text, "<") && text.substr(0, 1024).find("<amf") != std::string_view::npos;
}

/// Of a zip archive: the name of its first member, which stands in its header.
bool is_zipped_amf(std::string_view bytes) {
  constexpr std::size_t kHeader = 30, kLength = 26;
  if (bytes.size() < kHeader) return false;
  std::uint16_t length = 0;
  std::memcpy(&length, bytes.data() + kLength, sizeof length);
  return lowered(bytes.substr(kHeader, length)).ends_with(".amf");
}

bool looks_like_ascii_stl(std::string_view text) {
  text = without_leading_space(text);
  const std::string word =
      lowered(text.substr(0, std::min(text.find_first_of(" \t\v\f\r\n"), std::size_t{6})));
  return word == "solid" || word.starts_with("facet");
}

bool begins_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

}  // namespace

bool is_mesh_content(std::string_view head, std::uintmax_t size) {
  if (is_exact_binary_stl(head, size) || begins_ply(head)) return true;
  if (!is_text(head)) return false;
  const bool facets = lowered(head).find("facet") != std::string::npos;
  return (looks_like_ascii_stl(head) && facets) || looks_like_off(head) || looks_like_obj(head) ||
         looks_like_amf(head);
}

bool is_mesh_suffix(const std::filesystem::path& path) {
  return suffixes().contains(model_suffix(path));
}

MeshFormat detect_format(const Source& source, const std::filesystem::path& path) {
  const std::string_view bytes = source.bytes();
  if (is_exact_binary_stl(bytes, bytes.size())) return MeshFormat::StlBinary;
  if (const char* message = foreign_file(bytes)) source.fail(message);
  if (is_drawing(bytes)) {
    source.fail("is a drawing file, not a model; burin convert writes it in other formats");
  }
  if (starts(bytes, "PK\x03\x04") || starts(bytes, "PK\x05\x06")) {
    const bool amf = is_zipped_amf(bytes) || model_suffix(path) == ".amf";
    return amf ? MeshFormat::Amf : MeshFormat::ThreeMf;
  }
  if (looks_like_amf(bytes)) return MeshFormat::Amf;
  if (begins_ply(bytes)) return MeshFormat::Ply;
  const auto suffix = suffixes().find(model_suffix(path));
  const bool named = suffix != suffixes().end();
  if (is_text(bytes)) {
    if (looks_like_ascii_stl(bytes)) return MeshFormat::StlAscii;
    if (looks_like_off(bytes)) return MeshFormat::Off;
    if (looks_like_obj(bytes)) return MeshFormat::Obj;
    if (named && suffix->second == MeshFormat::StlBinary) {
      source.fail_at_line(
          bytes.data(),
          "is text but no ASCII STL, which begins with 'solid'; is it another format?");
    }
  }
  // Named as another format in text, or as none.
  const bool of_text = !named || suffix->second == MeshFormat::Obj;
  if (of_text && !is_text(bytes) && is_binary_stl_of_zero(bytes)) return MeshFormat::StlBinary;
  if (const std::string suffix_of = model_suffix(path);
      suffix_of == ".scad" || suffix_of == ".csg") {
    source.fail("is a packed program of OpenSCAD, which is read unpacked alone; unpack it first");
  }
  if (!named && is_text(bytes) && is_illustration_text(bytes)) {
    source.fail(is_standard_input(path)
                    ? "is an illustration, which names files beside it and is read from a file: "
                      "save it as NAME.burin.json"
                    : "is an illustration, not a model; burin draw draws it");
  }
  if (!named && is_standard_input(path) && is_text(bytes)) {
    source.fail(
        "is text of an unknown format: name the format with `input_format`; a program "
        "of OpenSCAD is read from a file, as it may name others: save it with the suffix .scad");
  }
  if (!named) {
    source.fail(
        fmt::format("is of no kind that is read (suffix '{}'): meshes, STEP, IGES, BREP, FreeCAD, "
                    "OpenSCAD, spline patches, functions, volumes; raw volumes need their layout, "
                    "and `input_format` names the format of other files",
                    model_suffix(path)));
  }
  if (suffix->second == MeshFormat::ThreeMf)
    source.fail("is no 3MF file: a 3MF is a zip archive; export it again");
  if (suffix->second == MeshFormat::Amf)
    source.fail("is no AMF file, which is XML with the element 'amf'; is it another format?");
  if (suffix->second == MeshFormat::Ply)
    source.fail("is no PLY file, which begins with the line 'ply'; is it another format?");
  if (suffix->second == MeshFormat::Obj && !is_text(bytes))
    source.fail_at_byte(0, "is binary data, not an OBJ; is it another format?");
  return suffix->second;
}

}  // namespace burin
