#pragma once
/// Volumes: samples on a grid, as scanners and simulations write them.

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>
#include <burin/surface/scene.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// How one sample is stored.
enum class SampleType : std::uint8_t { I8, U8, I16, U16, I32, U32, I64, U64, F32, F64 };

/// What a raw file holds, since it does not say so itself.
struct RawLayout {
  /// Samples along i (fastest), j and k.
  std::array<std::int32_t, 3> size{};
  SampleType type = SampleType::U8;
  bool big_endian = false;
  /// Model mm from sample to sample.
  Vec3 spacing{1};
  /// Bytes before the first sample.
  std::int64_t skip = 0;
};

/// "64x64x32", "64x64x32:u16", "64x64x32:f32be:1,1,1.5": size, type (u8, i16, f32 ..., then be for
/// big-endian; u8 where absent), spacing (1,1,1). Throws UsageError.
RawLayout parse_raw_layout(std::string_view text);

/// What no file says of its volume.
struct VolumeReadOptions {
  /// The surface is where the data takes this value; it must be given to draw.
  std::optional<double> level = {};
  /// Whether larger values are inside; absent = they are.
  std::optional<bool> inside_above = {};
  /// As in VolumeOptions.
  int degree = 3;
  bool interpolate = false;
  double smoothing = 0;
  /// As in ImplicitForm.
  double smallest_part = kSmallestVolumePart;
  /// The only way to read raw files; other files ignore it.
  std::optional<RawLayout> raw = {};
  /// Samples lie on a grid, and so may the triangles.
  Mesher mesher = Mesher::Nets;
};

/// A volume as it was read.
struct Volume {
  /// "NRRD", "NIfTI-1" ...
  std::string format;
  VolumeGrid grid;
  VolumeInfo info;
  Diagnostics diagnostics;
};

/// Whether the suffix (any case; also with .gz behind it) is .nrrd .nhdr .mha .mhd .inr .nii .hdr
/// .img .vti or .raw.
bool is_volume_suffix(const std::filesystem::path& path);
/// Whether the first bytes of a file can only be a volume's.
bool is_volume_content(std::string_view head);

/// Samples with the scale of the file (NIfTI's slope) applied, as floats: whole numbers beyond 2^24
/// and doubles are rounded. Coordinates are those of the file, in mm where it names another unit;
/// of a space that is left-handed by its name (NRRD's LAS, 3D-left-handed) one coordinate changes
/// its sign, or the model would be its mirror image. Samples that are no finite numbers count as
/// outside and are reported ("volume.not_finite").
///
/// NRRD and MetaImage with their data inside or in a file of its own, INRIA, NIfTI-1 and -2,
/// Analyze, VTK's .vti, raw; uncompressed, gzip, zlib, text. Throws InputError, with the line in
/// text headers, also for more or less than three dimensions and more than one value per sample.
/// Sizes are compared with the bytes of the file, and with a quarter of the memory, before anything
/// is allocated. Cost: 0.1 s for 16 MB unpacked and 0.1 s for unpacking it.
/// @cite Kindlmann2004, Cox2004
Volume read_volume(const std::filesystem::path& path, const VolumeReadOptions& options,
                   RunContext& context);

/// One part, named by the file; bounds clip it to a box. Throws InputError as read_volume does, and
/// where no level is given (the error names the range of the data and a level to try) or the data
/// does not reach it.
Scene read_volume_scene(const std::filesystem::path& path, const VolumeReadOptions& options,
                        const std::optional<Box3>& bounds, RunContext& context);

/// Without a level no surface is made: FileInfo::volume alone describes the file.
FileInfo inspect_volume(const std::filesystem::path& path, const VolumeReadOptions& options,
                        const std::optional<Box3>& bounds, RunContext& context);

}  // namespace burin
