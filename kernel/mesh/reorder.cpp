#include <burin/base/parallel.h>
#include <burin/mesh/reorder.h>

#include <algorithm>
#include <cstdlib>

namespace burin {

namespace {

/// Vertices this near in the order are near in the cache: 24 bytes each, so that 16384 fill 0.4 MB.
constexpr std::int64_t kNear = 16384;
constexpr int kBits = 10;  // of a Morton code along each axis: cells of a thousandth of the box

/// The share of triangles whose corners are far from one another or from those of the triangle
/// before.
double scattered_share(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  std::int64_t before = mesh.triangles.front()[0], far = 0;
  for (const Triangle& t : mesh.triangles) {
    const std::int64_t a = t[0], b = t[1], c = t[2];
    far += std::abs(a - before) > kNear || std::abs(a - b) > kNear || std::abs(a - c) > kNear;
    before = a;
  }
  return static_cast<double>(far) / static_cast<double>(mesh.triangles.size());
}

/// Spreads the ten low bits of `v` to every third place.
std::uint32_t spread(std::uint32_t v) {
  v = (v | (v << 16)) & 0x030000ffu;
  v = (v | (v << 8)) & 0x0300f00fu;
  v = (v | (v << 4)) & 0x030c30c3u;
  return (v | (v << 2)) & 0x09249249u;
}

struct Keyed {
  std::uint32_t key;
  std::uint32_t index;
};

/// Stable sort by key: least significant digit first.
void radix_sort(std::vector<Keyed>& items, int bits) {
  constexpr int kDigit = 11;
  std::vector<Keyed> other(items.size());
  for (int shift = 0; shift < bits; shift += kDigit) {
    const auto digit = [&](const Keyed& k) { return (k.key >> shift) & ((1u << kDigit) - 1); };
    std::vector<std::size_t> place((1u << kDigit) + 1, 0);
    for (const Keyed& k : items) ++place[digit(k) + 1];
    for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
    for (const Keyed& k : items) other[place[digit(k)]++] = k;
    items.swap(other);
  }
}

std::vector<Keyed> sorted_by_morton_code(const std::vector<Vec3>& positions) {
  Box3 box;
  for (const Vec3& p : positions) box.add(p);
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  const double cells = largest > 0 ? ((1 << kBits) - 1) / largest : 0;
  std::vector<Keyed> order(positions.size());
  parallel_for(positions.size(), kNear, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3 cell = (positions[v] - box.min) * cells;
      order[v] = {spread(static_cast<std::uint32_t>(cell.x)) |
                      spread(static_cast<std::uint32_t>(cell.y)) << 1 |
                      spread(static_cast<std::uint32_t>(cell.z)) << 2,
                  static_cast<std::uint32_t>(v)};
    }
  });
  radix_sort(order, 3 * kBits);
  return order;
}

}  // namespace

std::vector<std::uint32_t> morton_order(const std::vector<Vec3>& points) {
  const std::vector<Keyed> sorted = sorted_by_morton_code(points);
  std::vector<std::uint32_t> order(sorted.size());
  std::ranges::transform(sorted, order.begin(), &Keyed::index);
  return order;
}

bool reorder_for_cache(TriMesh& mesh) {
  if (scattered_share(mesh) < 0.1) return false;
  const std::vector<std::uint32_t> order = morton_order(mesh.positions);
  std::vector<Vec3> positions(mesh.positions.size());
  std::vector<std::uint32_t> renamed(mesh.positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    positions[i] = mesh.positions[order[i]];
    renamed[order[i]] = static_cast<std::uint32_t>(i);
  }
  std::vector<Keyed> faces(mesh.triangles.size());
  parallel_for(faces.size(), kNear, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      Triangle& t = mesh.triangles[f];
      t = {renamed[t[0]], renamed[t[1]], renamed[t[2]]};
      faces[f] = {std::min({t[0], t[1], t[2]}), static_cast<std::uint32_t>(f)};
    }
  });
  int bits = 1;
  while (bits < 32 && (mesh.positions.size() >> bits) != 0) ++bits;
  radix_sort(faces, bits);
  std::vector<Triangle> triangles(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) triangles[i] = mesh.triangles[faces[i].index];
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return true;
}

}  // namespace burin
