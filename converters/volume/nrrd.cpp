// NRRD headers: lines "field: value", a comment after #, an empty line before attached data.
#include "header_text.h"
#include "layout.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::volume {
namespace {

// Without "signed " and " int", which may stand around shorter names.
constexpr TypeName kNrrdTypes[] = {{"char", SampleType::I8},
                                   {"int8", SampleType::I8},
                                   {"int8_t", SampleType::I8},
                                   {"uchar", SampleType::U8},
                                   {"unsigned char", SampleType::U8},
                                   {"uint8", SampleType::U8},
                                   {"uint8_t", SampleType::U8},
                                   {"short", SampleType::I16},
                                   {"int16", SampleType::I16},
                                   {"int16_t", SampleType::I16},
                                   {"ushort", SampleType::U16},
                                   {"unsigned short", SampleType::U16},
                                   {"uint16", SampleType::U16},
                                   {"uint16_t", SampleType::U16},
                                   {"int", SampleType::I32},
                                   {"int32", SampleType::I32},
                                   {"int32_t", SampleType::I32},
                                   {"uint", SampleType::U32},
                                   {"unsigned int", SampleType::U32},
                                   {"uint32", SampleType::U32},
                                   {"uint32_t", SampleType::U32},
                                   {"longlong", SampleType::I64},
                                   {"long long", SampleType::I64},
                                   {"int64", SampleType::I64},
                                   {"int64_t", SampleType::I64},
                                   {"ulonglong", SampleType::U64},
                                   {"unsigned long long", SampleType::U64},
                                   {"uint64", SampleType::U64},
                                   {"uint64_t", SampleType::U64},
                                   {"float", SampleType::F32},
                                   {"double", SampleType::F64}};

struct Space {
  std::string_view name, short_name;
  // The coordinate whose sign makes it right-handed, -1: it is.
  int mirrored;
};
constexpr Space kSpaces[] = {
    {"right-anterior-superior", "ras", -1},     {"left-posterior-superior", "lps", -1},
    {"left-anterior-superior", "las", 0},       {"scanner-xyz", "scanner-xyz", -1},
    {"3d-right-handed", "3d-right-handed", -1}, {"3d-left-handed", "3d-left-handed", 1}};

// An axis of samples: its place in the file and what is told of it.
struct Axis {
  std::size_t index = 0;
  std::int64_t size = 0;
};

class NrrdHeader {
 public:
  explicit NrrdHeader(const Head& head) : head_(head), lines_(head.source), fields_(head.source) {}
  Layout read();

 private:
  void read_fields();
  void axes();
  void type();
  void encoding();
  void data();
  void oriented(const Field& directions);
  void spaced();
  // The entry of a field of one word an axis.
  std::vector<double> per_axis(const Field& field) const;
  // "(1,0,0)".
  Vec3 vector(const Field& field, std::string_view text) const;
  std::vector<std::string_view> vectors(const Field& field) const;
  // Model mm of a unit of the space, the same for all axes.
  double unit() const;

  const Head& head_;
  Lines lines_;
  Fields fields_;
  bool attached_ = false;
  std::size_t dimension_ = 0;
  std::vector<Axis> axes_;
  Layout out_;
};

// Words in quotes, or bare.
std::vector<std::string> quoted_words(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('"', at);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find('"', open + 1);
    if (close == std::string_view::npos) break;
    words.emplace_back(text.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return words;
}

Layout NrrdHeader::read() {
  read_fields();
  out_.format = "NRRD";
  axes();
  type();
  encoding();
  data();
  if (const Field* directions = fields_.find("space directions")) {
    oriented(*directions);
  } else {
    spaced();
  }
  return std::move(out_);
}

void NrrdHeader::read_fields() {
  lines_.next();  // the magic
  while (const auto line = lines_.next()) {
    if (line->empty()) {
      attached_ = true;
      return;
    }
    if (line->starts_with('#')) continue;
    const std::size_t colon = line->find(':');
    if (colon == std::string_view::npos) {
      lines_.fail(fmt::format("{} is no field of a NRRD header", in_quotes(*line)));
    }
    if (colon + 1 < line->size() && (*line)[colon + 1] == '=') continue;  // a note of its writer
    std::string key = lowered(trimmed(line->substr(0, colon)));
    // Other spellings of the same.
    if (key == "datafile") key = "data file";
    if (key == "lineskip") key = "line skip";
    if (key == "byteskip") key = "byte skip";
    if (key == "axismins") key = "axis mins";
    if (key == "axismaxs") key = "axis maxs";
    if (key == "centerings") key = "centers";
    fields_.add({std::move(key), trimmed(line->substr(colon + 1)), lines_.number()});
  }
}

void NrrdHeader::axes() {
  const Field& dimension = fields_.need("dimension");
  const std::int64_t d = fields_.integer(dimension);
  if (d < 1 || d > 16) fields_.fail(dimension, fmt::format("{} is no dimension from 1 to 16", d));
  dimension_ = static_cast<std::size_t>(d);
  const Field& field = fields_.need("sizes");
  const auto sizes = fields_.integers(field, dimension_);
  out_.size_line = field.line;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] < 1) fields_.fail(field, fmt::format("{} is no number of samples", sizes[i]));
    if (sizes[i] > 1 || sizes.size() == 3) axes_.push_back({i, sizes[i]});
  }
  if (axes_.size() == 3) {
    for (std::size_t k = 0; k < 3; ++k) out_.size[k] = axes_[k].size;
    return;
  }
  if (axes_.size() < 3) {
    fields_.fail(field, fmt::format("{}-D data is no volume; three axes of two samples or more "
                                    "are needed",
                                    axes_.size()));
  }
  fields_.fail(field, fmt::format("{}-D data (sizes {}), vectors, colours or several volumes, is "
                                  "not drawn; save one volume of scalars",
                                  axes_.size(), field.value));
}

void NrrdHeader::type() {
  const Field& field = fields_.need("type");
  std::string name = lowered(field.value);
  if (name.starts_with("signed ")) name.erase(0, 7);
  if (name.size() > 4 && name.ends_with(" int") && name != "unsigned int") {
    name.resize(name.size() - 4);
  }
  const auto* it = std::ranges::find(kNrrdTypes, name, &TypeName::name);
  if (it == std::end(kNrrdTypes)) {
    fields_.fail(field, fmt::format("{} is no type of samples that is read (from uchar to double)",
                                    in_quotes(field.value)));
  }
  out_.type = it->type;
}

void NrrdHeader::encoding() {
  const Field& field = fields_.need("encoding");
  const std::string name = lowered(field.value);
  if (name == "raw") {
    out_.encoding = Encoding::Raw;
  } else if (name == "gz" || name == "gzip") {
    out_.encoding = Encoding::Deflate;
  } else if (name == "txt" || name == "text" || name == "ascii") {
    out_.encoding = Encoding::Text;
  } else if (name == "hex") {
    out_.encoding = Encoding::Hex;
  } else {
    fields_.fail(field, fmt::format("the encoding {} is not read; save the file as raw or gzip",
                                    in_quotes(field.value)));
  }
  if (out_.encoding == Encoding::Text || bytes_of(out_.type) == 1) return;
  const Field& endian = fields_.need("endian");
  const std::string order = lowered(endian.value);
  if (order != "little" && order != "big") {
    fields_.fail(endian, fmt::format("{} is neither little nor big", in_quotes(endian.value)));
  }
  out_.order = order == "big" ? std::endian::big : std::endian::little;
}

void NrrdHeader::data() {
  if (const Field* skip = fields_.find("line skip")) {
    out_.skip_lines = fields_.integer(*skip);
    if (out_.skip_lines < 0) fields_.fail(*skip, "lines to skip are 0 or more");
  }
  if (const Field* skip = fields_.find("byte skip")) {
    out_.skip_bytes = fields_.integer(*skip);
    const bool good = out_.skip_bytes >= (out_.encoding == Encoding::Raw ? -1 : 0);
    if (!good) fields_.fail(*skip, "bytes to skip are 0 or more, or -1 for raw data");
  }
  const Field* file = fields_.find("data file");
  if (file == nullptr) {
    if (!attached_) head_.source.fail("the header has no end; the file is truncated");
    out_.header_bytes = lines_.offset();
    return;
  }
  if (file->value.starts_with("LIST") || file->value.find('%') != std::string_view::npos) {
    fields_.fail(*file, "data in several files is not read; save the volume in one");
  }
  out_.data_file = beside(head_, std::string(file->value), file->line);
}

Vec3 NrrdHeader::vector(const Field& field, std::string_view text) const {
  std::string words(text);
  const bool bracketed = words.size() > 2 && words.front() == '(' && words.back() == ')';
  if (!bracketed) {
    fields_.fail(field, fmt::format("{} is no vector (x,y,z)", in_quotes(text)));
  }
  std::ranges::replace(words, ',', ' ');
  const std::string_view inner = std::string_view(words).substr(1, words.size() - 2);
  const auto v = fields_.numbers({field.key, inner, field.line}, 3);
  return {v[0], v[1], v[2]};
}

std::vector<std::string_view> NrrdHeader::vectors(const Field& field) const {
  std::vector<std::string_view> out;
  std::string_view rest = trimmed(field.value);
  while (!rest.empty()) {
    const std::size_t end = rest.starts_with('(') ? rest.find(')') : rest.find_first_of(" \t(") - 1;
    out.push_back(rest.substr(0, end == std::string_view::npos ? end : end + 1));
    rest = trimmed(rest.substr(out.back().size()));
  }
  return out;
}

double NrrdHeader::unit() const {
  const Field* field = fields_.find_any({"space units", "units"});
  if (field == nullptr) return 1;
  const auto words = quoted_words(field->value);
  double mm = 0;
  for (const std::string& word : words) {
    if (word.empty() || word == "???") continue;
    if (mm != 0 && mm != mm_of(word)) {
      fields_.fail(*field, "the axes have different units; save the volume in mm");
    }
    mm = mm_of(word);
  }
  return mm == 0 ? 1 : mm;
}

void NrrdHeader::oriented(const Field& directions) {
  if (const Field* dimension = fields_.find("space dimension")) {
    if (fields_.integer(*dimension) != 3) {
      fields_.fail(*dimension, "a space of other than three dimensions is not drawn");
    }
  }
  const auto words = vectors(directions);
  if (words.size() != dimension_) {
    fields_.fail(directions, fmt::format("{} directions for {} axes", words.size(), dimension_));
  }
  const double mm = unit();
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = words[axes_[static_cast<std::size_t>(k)].index];
    if (lowered(word) == "none") {
      fields_.fail(directions,
                   "an axis has no direction in space: vectors, colours or several "
                   "volumes are not drawn; save one volume of scalars");
    }
    out_.steps[k] = mm * vector(directions, word);
  }
  if (const Field* origin = fields_.find("space origin")) {
    out_.origin = mm * vector(*origin, origin->value);
  }
  const Field* space = fields_.find("space");
  if (space == nullptr) return;
  const std::string name = lowered(space->value);
  const auto* it = std::ranges::find_if(
      kSpaces, [&](const Space& s) { return s.name == name || s.short_name == name; });
  if (it == std::end(kSpaces)) {
    fields_.fail(*space, fmt::format("{} is no space that is read, such as "
                                     "right-anterior-superior",
                                     in_quotes(space->value)));
  }
  out_.space = it->name;
  if (it->mirrored < 0) return;
  out_.origin[it->mirrored] *= -1;
  for (int k = 0; k < 3; ++k) out_.steps[k][it->mirrored] *= -1;
  out_.space += " (mirrored)";
}

std::vector<double> NrrdHeader::per_axis(const Field& field) const {
  const auto all = fields_.numbers(field, dimension_, true);
  std::vector<double> values;
  for (const Axis& axis : axes_) values.push_back(all[axis.index]);
  return values;
}

void NrrdHeader::spaced() {
  const double mm = unit();
  const Field* spacings = fields_.find("spacings");
  const Field *mins = fields_.find("axis mins"), *maxs = fields_.find("axis maxs");
  const Field* centers = fields_.find("centers");
  const std::vector<double> unknown(3, std::nan(""));
  const auto spacing = spacings ? per_axis(*spacings) : unknown;
  const auto low = mins ? per_axis(*mins) : unknown, high = maxs ? per_axis(*maxs) : unknown;
  const auto center = centers ? words_of(centers->value) : std::vector<std::string_view>();
  for (std::size_t k = 0; k < 3; ++k) {
    const bool cell = axes_[k].index < center.size() && lowered(center[axes_[k].index]) == "cell";
    const double steps = static_cast<double>(axes_[k].size) - (cell ? 0 : 1);
    double step = spacing[k];
    if (!std::isfinite(step)) step = (high[k] - low[k]) / steps;
    if (!std::isfinite(step)) step = 1;
    const auto axis = static_cast<int>(k);
    out_.steps[axis] = Vec3(0);
    out_.steps[axis][axis] = mm * step;
    if (std::isfinite(low[k])) out_.origin[axis] = mm * (low[k] + (cell ? step / 2 : 0));
  }
}

}  // namespace

Layout read_nrrd(const Head& head) { return NrrdHeader(head).read(); }

}  // namespace burin::volume
