#include "foreign_file.h"

#include <cstddef>

namespace burin {
namespace {

constexpr const char* kUtf16 = "is text in UTF-16; save it as UTF-8 or ASCII";

/// Whether every other byte is 0 and none between them: ASCII in UTF-16 without its mark.
bool is_unmarked_utf16(std::string_view bytes) {
  constexpr std::size_t kLeast = 16, kMost = 256;
  const std::string_view begin = bytes.substr(0, kMost);
  if (begin.size() < kLeast) return false;
  const bool high_first = begin.front() == 0;
  for (std::size_t i = 0; i < begin.size(); ++i) {
    const bool high = (i % 2 == 0) == high_first;
    if ((begin[i] == 0) != high || static_cast<signed char>(begin[i]) < 0) return false;
  }
  return true;
}

}  // namespace

const char* foreign_file(std::string_view bytes) {
  struct Magic {
    std::string_view bytes;
    const char* message;
  };
  using namespace std::string_view_literals;
  static constexpr Magic kMagic[] = {
      {"version https://git-lfs"sv,
       "is a Git LFS pointer, not the model; fetch it with 'git lfs pull'"},
      {"\xff\xfe"sv, kUtf16},
      {"\xfe\xff"sv, kUtf16},
      {"ISO-10303-21"sv, "is a STEP file; give it the suffix .step"},
      {"DBRep_DrawableShape"sv, "is an OpenCASCADE BREP file; give it the suffix .brep"},
      {"CASCADE Topology"sv, "is an OpenCASCADE BREP file; give it the suffix .brep"},
      {"glTF"sv, "is a binary glTF file; give it the suffix .glb"},
      {"Kaydara FBX"sv, "is an FBX file; convert it to STL, OBJ, OFF, PLY or 3MF"},
      {"BZh"sv, "is compressed by bzip2; unpack it first"},
      {"\xfd"
       "7zXZ"sv,
       "is compressed by xz; unpack it first"},
      {"%PDF"sv, "is a PDF document, not a model"},
      {"\x89PNG"sv, "is a PNG picture, not a model"},
      {"<!DOCTYPE"sv, "is a web page, not a model; download the file itself"},
      {"<html"sv, "is a web page, not a model; download the file itself"},
  };
  for (const Magic& m : kMagic) {
    if (bytes.starts_with(m.bytes)) return m.message;
  }
  return is_unmarked_utf16(bytes) ? kUtf16 : nullptr;
}

}  // namespace burin
