// NIfTI-1 and -2, and Analyze 7.5, whose header is that of NIfTI-1 without magic and orientation.
#include "binary.h"
#include "layout.h"
#include "text.h"

#include <fmt/format.h>

#include <cmath>

namespace burin::volume {
namespace {

struct TypeCode {
  int code;
  SampleType type;
};
constexpr TypeCode kTypeCodes[] = {
    {2, SampleType::U8},     {4, SampleType::I16},   {8, SampleType::I32},   {16, SampleType::F32},
    {64, SampleType::F64},   {256, SampleType::I8},  {512, SampleType::U16}, {768, SampleType::U32},
    {1024, SampleType::I64}, {1280, SampleType::U64}};

constexpr std::size_t kBytes1 = 348, kBytes2 = 540;

// Where things stand in the header of each version; dim, pixdim and the offsets have other types.
struct Places {
  std::size_t magic, datatype, slope, units, qform_code, sform_code, quatern, offset, srow;
};
constexpr Places kPlaces1{344, 70, 112, 123, 252, 254, 256, 268, 280};
constexpr Places kPlaces2{4, 12, 176, 500, 344, 348, 352, 376, 400};

class NiftiHeader {
 public:
  explicit NiftiHeader(const Head& head) : head_(head), bytes_(head.source.bytes()) {}
  Layout read();

 private:
  template <class T>
  T at(std::size_t offset) const {
    return load<T>(bytes_.data() + offset, order_);
  }
  // A number that version 1 has as a float and version 2 as a double.
  double real(std::size_t offset) const { return second_ ? at<double>(offset) : at<float>(offset); }
  // Reals that stand one after another.
  double real(std::size_t offset, int index) const {
    return real(offset + static_cast<std::size_t>(index) * (second_ ? 8 : 4));
  }
  int code(std::size_t offset) const {
    return second_ ? at<std::int32_t>(offset) : at<std::int16_t>(offset);
  }
  std::int64_t dim(std::size_t i) const {
    return second_ ? at<std::int64_t>(16 + 8 * i) : at<std::int16_t>(40 + 2 * i);
  }
  double pixdim(int i) const { return real(second_ ? 104 : 76, i); }

  void version();
  void sizes();
  void scale();
  void place();
  void by_quaternion(double mm);
  void data();

  const Head& head_;
  std::string_view bytes_;
  std::endian order_ = std::endian::little;
  bool second_ = false;
  bool analyze_ = false;
  bool pair_ = false;
  Places places_ = kPlaces1;
  Layout out_;
};

bool is_size(std::string_view bytes, std::endian order, std::size_t size) {
  return bytes.size() >= size && load<std::uint32_t>(bytes.data(), order) == size;
}

void NiftiHeader::version() {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const std::size_t size : {kBytes1, kBytes2}) {
      if (!is_size(bytes_, order, size)) continue;
      order_ = order;
      second_ = size == kBytes2;
      places_ = second_ ? kPlaces2 : kPlaces1;
      const std::string_view magic = bytes_.substr(places_.magic, 3);
      pair_ = magic.starts_with("ni");
      analyze_ = !second_ && magic != "n+1" && magic != "ni1";
      if (second_ && magic != "n+2" && magic != "ni2") {
        head_.source.fail("the header of NIfTI-2 lacks its magic, n+2; the file is damaged");
      }
      pair_ |= analyze_;
      return;
    }
  }
  head_.source.fail("does not begin with a NIfTI header; it is truncated, or another format");
}

void NiftiHeader::sizes() {
  const std::int64_t axes = dim(0);
  if (axes < 1 || axes > 7) {
    head_.source.fail(fmt::format("{} is no number of axes, 1 to 7; the header is damaged", axes));
  }
  if (axes < 3) head_.source.fail(fmt::format("{}-D data is no volume", axes));
  for (std::size_t i = 4; i <= static_cast<std::size_t>(axes); ++i) {
    if (dim(i) <= 1) continue;
    head_.source.fail(
        fmt::format("{}-D data, {} volumes or values a sample, is not drawn; save "
                    "one volume of scalars",
                    axes, dim(i)));
  }
  for (std::size_t i = 0; i < 3; ++i) out_.size[i] = dim(i + 1);
  const int type = at<std::int16_t>(places_.datatype);
  for (const TypeCode& t : kTypeCodes) {
    if (t.code == type) out_.type = t.type;
  }
  const bool known = std::ranges::any_of(kTypeCodes, [&](auto& t) { return t.code == type; });
  if (known) return;
  const bool colour = type == 128 || type == 2304, complex = type == 32 || type == 1792;
  head_.source.fail(
      fmt::format("samples of data type {}{} are not read; save one volume of scalars", type,
                  colour    ? " (colours)"
                  : complex ? " (complex numbers)"
                            : ""));
}

void NiftiHeader::scale() {
  if (analyze_) return;
  const double slope = real(places_.slope), intercept = real(places_.slope, 1);
  if (slope == 0 || !std::isfinite(slope) || !std::isfinite(intercept)) return;
  out_.slope = slope;
  out_.intercept = intercept;
}

void NiftiHeader::by_quaternion(double mm) {
  const double b = real(places_.quatern, 0), c = real(places_.quatern, 1),
               d = real(places_.quatern, 2);
  const double rest = 1 - (b * b + c * c + d * d);
  const double a = rest > 0 ? std::sqrt(rest) : 0;
  // Rows of the rotation.
  const Vec3 x(a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c));
  const Vec3 y(2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b));
  const Vec3 z(2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c);
  const double third = pixdim(0) < 0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) {
    out_.steps[k] = mm * pixdim(k + 1) * (k == 2 ? third : 1) * Vec3(x[k], y[k], z[k]);
    out_.origin[k] = mm * real(places_.offset, k);
  }
}

void NiftiHeader::place() {
  const int units = (second_ ? at<std::int32_t>(places_.units)
                             : static_cast<int>(at<std::uint8_t>(places_.units))) &
                    7;
  const double mm = analyze_ ? 1 : units == 1 ? 1e3 : units == 3 ? 1e-3 : 1;
  for (int k = 0; k < 3; ++k) {
    const double step = std::abs(pixdim(k + 1));
    out_.steps[k] = Vec3(0);
    out_.steps[k][k] = mm * (step > 0 ? step : 1);
  }
  if (analyze_) return;
  if (code(places_.sform_code) > 0) {
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 3; ++k) out_.steps[k][row] = mm * real(places_.srow, 4 * row + k);
      out_.origin[row] = mm * real(places_.srow, 4 * row + 3);
    }
  } else if (code(places_.qform_code) > 0) {
    by_quaternion(mm);
  } else {
    return;
  }
  out_.space = "right-anterior-superior";
}

void NiftiHeader::data() {
  const std::size_t header = second_ ? kBytes2 : kBytes1;
  const double offset = second_ ? static_cast<double>(at<std::int64_t>(168)) : at<float>(108);
  if (!(offset >= 0 && offset < 1e15) || offset != std::floor(offset)) {
    head_.source.fail(
        fmt::format("{} is no place where data can begin; the header is damaged", offset));
  }
  out_.skip_bytes = static_cast<std::int64_t>(offset);
  if (pair_) {
    std::filesystem::path name = head_.path.filename();
    const bool packed = lowered(name.extension().string()) == ".gz";
    if (packed) name = name.stem();
    const bool upper = name.extension() == ".HDR";
    name.replace_extension(upper ? ".IMG" : ".img");
    std::error_code error;
    for (const char* end : {packed ? ".gz" : "", packed ? "" : ".gz"}) {
      out_.data_file = head_.path.parent_path() / (name.string() + end);
      if (std::filesystem::is_regular_file(out_.data_file, error)) return;
    }
    out_.data_file = beside(head_, name.string(), 0);
    return;
  }
  // Some programs leave 0 for "behind the header and its four flags".
  if (offset == 0) out_.skip_bytes = static_cast<std::int64_t>(header + 4);
  if (out_.skip_bytes < static_cast<std::int64_t>(header)) {
    head_.source.fail(
        fmt::format("the data would begin at byte {}, within the header; the header "
                    "is damaged",
                    offset));
  }
}

Layout NiftiHeader::read() {
  version();
  out_.format = analyze_ ? "Analyze" : second_ ? "NIfTI-2" : "NIfTI-1";
  out_.order = order_;
  sizes();
  scale();
  place();
  data();
  return std::move(out_);
}

}  // namespace

Layout read_nifti(const Head& head) { return NiftiHeader(head).read(); }

}  // namespace burin::volume
