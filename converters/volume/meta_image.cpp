// MetaImage headers: lines "Key = value"; ElementDataFile is the last.
#include "header_text.h"
#include "layout.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::volume {
namespace {

// MET_LONG is 4 bytes in files of 32-bit and Windows programs, 8 in others: the size of the data
// would have to decide, so it is refused.
constexpr TypeName kMetaTypes[] = {
    {"MET_CHAR", SampleType::I8},       {"MET_UCHAR", SampleType::U8},
    {"MET_SHORT", SampleType::I16},     {"MET_USHORT", SampleType::U16},
    {"MET_INT", SampleType::I32},       {"MET_UINT", SampleType::U32},
    {"MET_LONG_LONG", SampleType::I64}, {"MET_ULONG_LONG", SampleType::U64},
    {"MET_FLOAT", SampleType::F32},     {"MET_DOUBLE", SampleType::F64}};

class MetaHeader {
 public:
  explicit MetaHeader(const Head& head) : head_(head), lines_(head.source), fields_(head.source) {}
  Layout read();

 private:
  void read_fields();
  void samples();
  void place();
  void data();
  bool yes(std::initializer_list<std::string_view> keys, bool otherwise) const;

  const Head& head_;
  Lines lines_;
  Fields fields_;
  Layout out_;
};

void MetaHeader::read_fields() {
  while (const auto line = lines_.next()) {
    if (trimmed(*line).empty()) continue;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) {
      lines_.fail(fmt::format("{} is no field of a MetaImage header", in_quotes(*line)));
    }
    const std::string_view key = trimmed(line->substr(0, equals));
    fields_.add({std::string(key), trimmed(line->substr(equals + 1)), lines_.number()});
    if (key == "ElementDataFile") return;
  }
}

bool MetaHeader::yes(std::initializer_list<std::string_view> keys, bool otherwise) const {
  const Field* field = fields_.find_any(keys);
  if (field == nullptr) return otherwise;
  const std::string word = lowered(field->value);
  const bool good = word == "true" || word == "false" || word == "1" || word == "0";
  if (!good) fields_.fail(*field, fmt::format("{} is not True or False", in_quotes(field->value)));
  return word == "true" || word == "1";
}

void MetaHeader::samples() {
  if (const Field* object = fields_.find("ObjectType"); object && object->value != "Image") {
    fields_.fail(*object, fmt::format("{} is no Image", in_quotes(object->value)));
  }
  const Field& sizes = fields_.need("DimSize");
  const Field& dims = fields_.need("NDims");
  const std::int64_t n = fields_.integer(dims);
  if (n < 3) fields_.fail(dims, fmt::format("{}-D data is no volume; three axes are needed", n));
  if (n > 3) {
    fields_.fail(dims,
                 fmt::format("{}-D data, several volumes, is not drawn; save one of them", n));
  }
  const auto size = fields_.integers(sizes, 3);
  std::ranges::copy(size, out_.size.begin());
  out_.size_line = sizes.line;
  if (const Field* channels = fields_.find("ElementNumberOfChannels")) {
    if (fields_.integer(*channels) != 1) {
      fields_.fail(*channels, "vectors and colours are not drawn; save one volume of scalars");
    }
  }
  const Field& type = fields_.need("ElementType");
  const auto* it = std::ranges::find(kMetaTypes, type.value, &TypeName::name);
  if (it == std::end(kMetaTypes)) {
    fields_.fail(type, fmt::format("{} is no type of samples that is read (from MET_CHAR to "
                                   "MET_DOUBLE)",
                                   in_quotes(type.value)));
  }
  out_.type = it->type;
  const bool big = yes({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  out_.order = big ? std::endian::big : std::endian::little;
}

void MetaHeader::place() {
  Vec3 spacing(1);
  if (const Field* field = fields_.find_any({"ElementSpacing", "ElementSize"})) {
    const auto v = fields_.numbers(*field, 3);
    spacing = {v[0], v[1], v[2]};
  }
  if (const Field* field = fields_.find_any({"Offset", "Position", "Origin"})) {
    const auto v = fields_.numbers(*field, 3);
    out_.origin = {v[0], v[1], v[2]};
  }
  for (int k = 0; k < 3; ++k) {
    out_.steps[k] = Vec3(0);
    out_.steps[k][k] = spacing[k];
  }
  if (const Field* field = fields_.find_any({"TransformMatrix", "Orientation", "Rotation"})) {
    // One axis after the other.
    const auto m = fields_.numbers(*field, 9);
    for (int k = 0; k < 3; ++k) {
      const auto row = 3 * static_cast<std::size_t>(k);
      out_.steps[k] = spacing[k] * Vec3(m[row], m[row + 1], m[row + 2]);
    }
  }
  if (const Field* field = fields_.find("AnatomicalOrientation")) {
    out_.space = in_quotes(field->value);
  }
}

void MetaHeader::data() {
  if (yes({"CompressedData"}, false)) {
    out_.encoding = Encoding::Deflate;
  } else if (!yes({"BinaryData"}, true)) {
    out_.encoding = Encoding::Text;
  }
  if (const Field* skip = fields_.find("HeaderSize")) {
    out_.skip_bytes = fields_.integer(*skip);
    const bool good = out_.skip_bytes >= (out_.encoding == Encoding::Raw ? -1 : 0);
    if (!good) fields_.fail(*skip, "a header size is 0 or more, or -1 for raw data");
  }
  const Field& file = fields_.need("ElementDataFile");
  if (file.value == "LOCAL" || file.value == "Local" || file.value == "local") {
    out_.header_bytes = lines_.offset();
    return;
  }
  if (file.value.starts_with("LIST") || file.value.find('%') != std::string_view::npos) {
    fields_.fail(file, "data in several files is not read; save the volume in one");
  }
  out_.data_file = beside(head_, std::string(file.value), file.line);
}

Layout MetaHeader::read() {
  out_.format = "MetaImage";
  read_fields();
  samples();
  place();
  data();
  return std::move(out_);
}

}  // namespace

Layout read_meta_image(const Head& head) { return MetaHeader(head).read(); }

}  // namespace burin::volume
