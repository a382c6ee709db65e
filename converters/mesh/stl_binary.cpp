#include <burin/base/parallel.h>
#include <burin/repair/weld.h>

#include "formats.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

namespace burin {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kRecord = 50;  // normal, three corners (floats), two bytes of attributes
constexpr std::size_t kNormal = 12;
using Corner = std::array<float, 3>;

/// How many triangles the file holds: what it claims, or where it claims none, as programs do that
/// did not know the number when they began, what its length says.
std::size_t triangle_count(const Source& source, Diagnostics& diagnostics) {
  const std::string_view bytes = source.bytes();
  if (bytes.size() < kHeader) {
    source.fail_at_byte(bytes.size(),
                        "the file ends inside the 84-byte header of a binary STL; it is "
                        "truncated, export it again");
  }
  std::uint32_t claimed = 0;
  std::memcpy(&claimed, bytes.data() + 80, sizeof claimed);
  const std::size_t held = (bytes.size() - kHeader) / kRecord;
  const bool whole = (bytes.size() - kHeader) % kRecord == 0;
  constexpr std::uint32_t kUnknown = 0xFFFFFFFF;  // of exporters that stream
  if (claimed > held && !(claimed == kUnknown && whole)) {
    source.fail_at_byte(80,
                        fmt::format("the binary STL claims {} triangles, its bytes hold {}; it is "
                                    "truncated or no STL, export it again",
                                    claimed, held));
  }
  if (held == 0) source.fail_at_byte(80, "the binary STL holds no triangles; export it again");
  if (claimed > 0 && claimed != kUnknown) {
    if (held > claimed && whole) {
      diagnostics.add(Severity::Warning, "stl.more_triangles", 1,
                      fmt::format("the binary STL gives {} as the number of its triangles, by its "
                                  "length it holds {}; those beyond are left out",
                                  claimed, held));
    }
    return claimed;
  }
  diagnostics.add(
      Severity::Warning, "stl.zero_count", 1,
      fmt::format("the binary STL gives {} as the number of its triangles; by the length "
                  "of the file it holds {}",
                  claimed, held));
  return held;
}

}  // namespace

// Little-endian records are copied as they are: Burin runs on little-endian machines only.
MeshFile read_stl_binary(const Source& source) {
  MeshFile file;
  file.format = "STL (binary)";
  const std::size_t n = triangle_count(source, file.diagnostics);
  const std::string_view bytes = source.bytes();
  const auto corners = std::make_unique_for_overwrite<Corner[]>(3 * n);
  parallel_for(
      n, 65536,
      [&](std::size_t begin, std::size_t end) {
        const char* record = bytes.data() + kHeader + kRecord * begin;
        for (std::size_t t = begin; t < end; ++t, record += kRecord) {
          std::memcpy(&corners[3 * t], record + kNormal, 3 * sizeof(Corner));
        }
      },
      &source.context());

  PolygonSoup& soup = file.objects.emplace_back();
  Weld welded = weld({corners.get(), 3 * n}, source.context());
  soup.positions.resize(welded.first.size());
  parallel_for(welded.first.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Corner& c = corners[welded.first[i]];
      soup.positions[i] = Vec3(c[0], c[1], c[2]);
    }
  });
  soup.indices = std::move(welded.vertex);
  soup.offsets.resize(n + 1);
  for (std::size_t i = 0; i <= n; ++i) soup.offsets[i] = 3 * i;

  const std::size_t extra = bytes.size() - kHeader - kRecord * n;
  if (extra > 0) {
    file.diagnostics.add(Severity::Info, "stl.trailing_bytes", static_cast<std::int64_t>(extra),
                         "bytes after the last triangle of the STL were ignored");
  }
  return file;
}

}  // namespace burin
