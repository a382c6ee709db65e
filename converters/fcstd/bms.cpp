#include "bms.h"

#include "binary.h"

namespace burin::detail {
namespace {

constexpr std::uint32_t kMagic = 0xA0B0C0D0;
constexpr std::size_t kHead = 8 + 256;  // magic, version, a text
constexpr std::size_t kPoint = 3 * sizeof(float);
// Three corners and three neighbours.
constexpr std::size_t kFacet = 6 * sizeof(std::uint32_t);

}  // namespace

PolygonSoup read_bms(const Source& source) {
  const std::string_view bytes = source.bytes();
  if (bytes.size() < kHead + 8) source.fail("the mesh ends early");
  std::endian order = std::endian::little;
  if (load<std::uint32_t>(bytes.data(), order) != kMagic) order = std::endian::big;
  if (load<std::uint32_t>(bytes.data(), order) != kMagic) {
    source.fail(
        "the mesh is of a kind that is not known; save the document with FreeCAD 0.15 or "
        "newer");
  }
  const std::size_t points = load<std::uint32_t>(bytes.data() + kHead, order);
  const std::size_t facets = load<std::uint32_t>(bytes.data() + kHead + 4, order);
  // Both counts are below 2^32: no overflow.
  if (bytes.size() - kHead - 8 < points * kPoint + facets * kFacet) {
    source.fail("the mesh ends early");
  }
  PolygonSoup soup;
  const char* p = bytes.data() + kHead + 8;
  soup.positions.reserve(points);
  for (std::size_t i = 0; i < points; ++i, p += kPoint) {
    soup.positions.emplace_back(load<float>(p, order), load<float>(p + 4, order),
                                load<float>(p + 8, order));
  }
  for (std::size_t i = 0; i < facets; ++i, p += kFacet) {
    if (i % 65536 == 0) source.context().check();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = load<std::uint32_t>(p + 4 * k, order);
      if (corner >= points) source.fail("a facet of the mesh names a point that does not exist");
      soup.indices.push_back(corner);
    }
    soup.offsets.push_back(soup.indices.size());
  }
  return soup;
}

}  // namespace burin::detail
