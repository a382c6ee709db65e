#include <burin/base/error.h>
#include <burin/converters/volume_reader.h>

#include "../readers.h"
#include "all.h"

namespace burin::detail {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 50;

std::vector<ReadRow> volume_rows() {
  return {
      {{{.option =
             {.name = "smooth",
              .meaning =
                  "standard deviation of a Gaussian that a volume is smoothed with (default 0)",
              .takes = NumberRange{0, 100, "samples"},
              .phrase = "a standard deviation of 0 to 100 samples"},
         .group = kData,
         .label = "SAMPLES",
         .also = {"blur", "gauss", "sigma", "denoise"}},
        number_to([](ReadOptions& o) -> double& { return o.volume.smoothing; })},
       Volumes,
       "volumes"},
      {{{.option =
             {.name = "specks",
              .meaning =
                  "components of a volume smaller than this share of the largest one are left "
                  "out (default 0.02)",
              .takes = NumberRange{0, 0.99},
              .phrase = "a share from 0 to 0.99 of the largest component's size"},
         .group = kData,
         .label = "SHARE"},
        number_to([](ReadOptions& o) -> double& { return o.volume.smallest_part; })},
       Volumes,
       "volumes"},
      {{{.option = {.name = "volume_degree",
                    .meaning = "degree of the spline of a volume (default 3)",
                    .takes = WholeRange{2, 3},
                    .phrase = "2 or 3"},
         .group = kData,
         .label = "2|3"},
        [](ReadOptions& o, const Asked& a) {
          o.volume.degree = static_cast<int>(std::get<std::uint64_t>(a.value));
        }},
       Volumes,
       "volumes"},
      {{{.option = {.name = "interpolate",
                    .meaning =
                        "take the values of the samples exactly; without it they are the spline's "
                        "coefficients, a little smoother",
                    .takes = Switch{}},
         .group = kData},
        [](ReadOptions& o, const Asked& a) { o.volume.interpolate = std::get<bool>(a.value); }},
       Volumes,
       "volumes"},
      {{{.option = {.name = "raw",
                    .meaning =
                        "what a raw file holds: NXxNYxNZ[:TYPE[:DX,DY,DZ]], TYPE u8 i8 u16 .. f64, "
                        "u16be .. for big-endian (default u8:1,1,1)",
                    .takes = FreeText{}},
         .group = kData,
         .label = "NXxNYxNZ[..]"},
        [](ReadOptions& o, const Asked& a) { o.volume.raw = parse_raw_layout(a.text()); }},
       Volumes,
       "files of raw samples, which have no header"},
      {{{.option = {.name = "raw_skip",
                    .meaning = "bytes before the first sample of a raw file (default 0)",
                    .takes = WholeRange{0, kMostBytes},
                    .phrase = "a number of bytes"},
         .group = kData,
         .label = "BYTES"},
        [](ReadOptions& o, const Asked& a) {
          if (!o.volume.raw) throw UsageError(a.spelled + " goes with `raw`");
          o.volume.raw->skip = static_cast<std::int64_t>(std::get<std::uint64_t>(a.value));
        }},
       Volumes,
       "files of raw samples"},
  };
}

}  // namespace

const Reader kVolume{"volumes (.nrrd .nhdr .mha .mhd .inr .nii .nii.gz .vti, .raw with --raw)",
                     is_volume_content,
                     is_volume_suffix,
                     [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                       return ReadResult{read_volume_scene(path, o.volume, o.bounds, c)};
                     },
                     [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                       return inspect_volume(path, o.volume, o.bounds, c);
                     },
                     Volumes,
                     {},
                     volume_rows};

}  // namespace burin::detail
