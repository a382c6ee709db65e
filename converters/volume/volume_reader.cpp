#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/volume_reader.h>
#include <burin/forms/implicit/implicit_form.h>

#include "binary.h"
#include "bytes.h"
#include "layout.h"
#include "packed.h"
#include "samples.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace volume {
namespace {

// What is unpacked of a compressed file to find its header.
constexpr std::size_t kHead = std::size_t{1} << 21;

bool is_nifti(std::string_view head) {
  if (head.size() < 348) return false;
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto size = load<std::uint32_t>(head.data(), order);
    const std::string_view magic = head.substr(size == 348 ? 344 : 4, 3);
    if (size == 348 && (magic == "n+1" || magic == "ni1")) return true;
    if (size == 540 && (magic == "n+2" || magic == "ni2")) return true;
  }
  return false;
}

bool is_meta_image(std::string_view head) {
  return head.starts_with("ObjectType") || head.starts_with("NDims");
}

bool is_vti(std::string_view head) {
  const std::string_view begin = head.substr(0, 1024);
  return begin.find("<VTKFile") != std::string_view::npos &&
         begin.find("\"ImageData\"") != std::string_view::npos;
}

using ReadLayout = Layout (*)(const Head&);

struct Format {
  bool (*knows)(std::string_view head);
  std::array<std::string_view, 3> suffixes;
  ReadLayout read;
};
constexpr Format kFormats[] = {
    {[](std::string_view head) { return head.starts_with("NRRD000"); },
     {".nrrd", ".nhdr"},
     read_nrrd},
    {[](std::string_view head) { return head.starts_with("#INRIMAGE-4#{"); },
     {".inr"},
     read_inrimage},
    {is_nifti, {".nii", ".hdr", ".img"}, read_nifti},
    {is_vti, {".vti"}, read_vti},
    {is_meta_image, {".mha", ".mhd"}, read_meta_image}};

// By content, then by suffix.
ReadLayout format_of(const Head& head) {
  const std::string_view bytes = head.source.bytes();
  for (const Format& format : kFormats) {
    if (format.knows(bytes)) return format.read;
  }
  const std::string suffix = model_suffix(head.path);
  if (suffix == ".nrrd" || suffix == ".nhdr") {
    head.source.fail("does not begin with NRRD000; it is damaged, or another format");
  }
  if (suffix == ".inr") {
    head.source.fail("does not begin with #INRIMAGE-4#{; it is damaged, or another format");
  }
  for (const Format& format : kFormats) {
    if (std::ranges::find(format.suffixes, suffix) != format.suffixes.end()) return format.read;
  }
  head.source.fail(
      "is raw data, which does not state its size; give `raw NXxNYxNZ[:TYPE[:DX,DY,DZ]]`");
}

// The header of a pair when its data was named.
std::filesystem::path header_path(const std::filesystem::path& path) {
  if (model_suffix(path) != ".img") return path;
  const bool packed = lowered(path.extension().string()) == ".gz";
  const std::filesystem::path plain = packed ? path.parent_path() / path.stem() : path;
  std::filesystem::path header = plain;
  header.replace_extension(plain.extension() == ".IMG" ? ".HDR" : ".hdr");
  std::error_code error;
  for (const char* end : {"", ".gz"}) {
    if (std::filesystem::is_regular_file(header.string() + end, error)) {
      return header.string() + end;
    }
  }
  return path;
}

class Reader {
 public:
  Reader(const std::filesystem::path& path, const VolumeReadOptions& options, RunContext& context)
      : path_(path), options_(options), context_(context) {}
  Volume read();

 private:
  bool is_raw(std::string_view head) const;
  Layout layout(const Source& file, bool packed);
  void fill(const Layout& layout, Volume& volume) const;

  const std::filesystem::path& path_;
  const VolumeReadOptions& options_;
  RunContext& context_;
};

bool Reader::is_raw(std::string_view head) const {
  return options_.raw && !is_volume_content(head) &&
         (model_suffix(path_) == ".raw" || !is_volume_suffix(path_));
}

Layout Reader::layout(const Source& file, bool packed) {
  if (!packed) {
    if (is_raw(file.bytes())) return raw_layout(*options_.raw);
    const Head head{file, path_};
    return format_of(head)(head);
  }
  const Source unpacked(file.file(),
                        take(*unpacked_bytes(file.bytes(), file.file(), context_), kHead, context_),
                        context_);
  if (is_raw(unpacked.bytes())) return raw_layout(*options_.raw);
  const Head head{unpacked, path_};
  const ReadLayout read_layout = format_of(head);
  if (read_layout != read_vti) return read_layout(head);
  if (unpacked.bytes().size() == kHead) file.fail("is too large to be read packed; unpack it");
  return read_layout(head);
}

void Reader::fill(const Layout& layout, Volume& volume) const {
  VolumeInfo& info = volume.info;
  info.size = layout.size;
  info.type = name_of(layout.type);
  info.whole = info.type[0] != 'f' && layout.slope == std::floor(layout.slope) &&
               layout.intercept == std::floor(layout.intercept);
  info.origin = layout.origin;
  info.steps = layout.steps;
  info.space = layout.space;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p = layout.origin;
    for (int k = 0; k < 3; ++k) {
      if ((corner >> k & 1) == 0) continue;
      p += static_cast<double>(layout.size[static_cast<std::size_t>(k)] - 1) * layout.steps[k];
    }
    info.bounds.add(p);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    volume.grid.size[k] = static_cast<std::int32_t>(layout.size[k]);
  }
  volume.grid.origin = layout.origin;
  volume.grid.steps = layout.steps;
}

Volume Reader::read() {
  const Source file = as_it_is(path_, context_);
  const bool packed = is_gzip(file.bytes()) && !is_raw(file.bytes());
  Layout one = layout(file, packed);
  check_layout(one, file.file());
  Volume volume;
  volume.format = one.format;
  if (one.data_file.empty()) {
    volume.grid.samples = load_samples(one, file, packed && !one.payload, context_);
  } else {
    const Source data = as_it_is(one.data_file, context_);
    const bool gzip = is_gzip(data.bytes()) && one.encoding == Encoding::Raw;
    volume.grid.samples = load_samples(one, data, gzip, context_);
  }
  one.payload.reset();
  fill(one, volume);
  const Finite finite =
      make_finite(volume.grid.samples, options_.inside_above.value_or(true), file.file(), context_);
  volume.info.min = finite.min;
  volume.info.max = finite.max;
  volume.diagnostics = std::move(one.diagnostics);
  if (finite.bad > 0) {
    volume.diagnostics.add(Severity::Warning, "volume.not_finite", finite.bad,
                           "samples that are no numbers, infinite or absurdly large count as "
                           "outside");
  }
  return volume;
}

}  // namespace
}  // namespace volume

bool is_volume_suffix(const std::filesystem::path& path) {
  const std::string suffix = model_suffix(path);
  if (suffix.empty()) return false;
  if (suffix == ".raw") return true;
  return std::ranges::any_of(volume::kFormats, [&](const volume::Format& format) {
    return std::ranges::find(format.suffixes, suffix) != format.suffixes.end();
  });
}

bool is_volume_content(std::string_view head) {
  return std::ranges::any_of(volume::kFormats,
                             [&](const volume::Format& format) { return format.knows(head); });
}

Volume read_volume(const std::filesystem::path& path, const VolumeReadOptions& options,
                   RunContext& context) {
  Volume out = volume::Reader(volume::header_path(path), options, context).read();
  volume::describe(out.grid.samples, out.info, context);
  return out;
}

}  // namespace burin
