#pragma once
// What a header says of the samples; internal to the module.

#include <burin/converters/volume_reader.h>

#include "source.h"

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace burin::volume {

/// What a format calls a type of samples.
struct TypeName {
  std::string_view name;
  SampleType type;
};

enum class Encoding : std::uint8_t { Raw, Deflate, Text, Hex };

struct Layout {
  std::string format;
  std::array<std::int64_t, 3> size{};
  SampleType type = SampleType::U8;
  std::endian order = std::endian::little;
  Encoding encoding = Encoding::Raw;
  // Values are slope * sample + intercept.
  double slope = 1, intercept = 0;

  Vec3 origin{0};
  Mat3 steps{1};
  // What the axes are, in words: "right, anterior, superior".
  std::string space;

  // Where the data was taken out of a document already: these are its bytes.
  std::optional<std::string> payload;
  // Empty: in the file of the header.
  std::filesystem::path data_file;
  // Where the data begins in the unpacked file of the header.
  std::size_t header_bytes = 0;
  // To go past at the beginning of the data.
  std::int64_t skip_lines = 0;
  // -1: the data is what stands at the end of its file.
  std::int64_t skip_bytes = 0;
  // Where the header is text, the line that errors of size name.
  std::int64_t size_line = 0;

  Diagnostics diagnostics;

  double samples() const {
    return static_cast<double>(size[0]) * static_cast<double>(size[1]) *
           static_cast<double>(size[2]);
  }
};

std::size_t bytes_of(SampleType type);
// "u16".
const char* name_of(SampleType type);

// Refuses sizes below 2 and volumes larger than this machine's memory allows, and grids whose steps
// are no three independent finite vectors.
void check_layout(const Layout& layout, const std::string& file);

// The unpacked file, or its first part, whole enough to hold the header.
struct Head {
  const Source& source;
  const std::filesystem::path& path;
};

Layout read_nrrd(const Head& head);
Layout read_meta_image(const Head& head);
Layout read_inrimage(const Head& head);
Layout read_nifti(const Head& head);
Layout read_vti(const Head& head);
Layout raw_layout(const RawLayout& raw);

// By the names of name_of.
std::optional<SampleType> type_of(std::string_view word);
// Model mm of a unit of length, 1 where it is unknown.
double mm_of(std::string_view unit);

// The file beside the header that `name` says; throws where it is the header itself.
std::filesystem::path beside(const Head& head, const std::string& name, std::int64_t line);

}  // namespace burin::volume
