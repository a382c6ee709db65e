#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/repair/weld.h>

#include <algorithm>
#include <bit>
#include <memory>

namespace burin {
namespace {

// Points are first dealt to buckets by hash, so that the table of a bucket fits the cache: one
// table for all of them would miss it at every look-up.
constexpr std::size_t kBucketSize = 8192;
constexpr std::size_t kMaxBuckets = 4096;
constexpr std::size_t kMaxChunks = 64;
constexpr std::size_t kMinChunk = 32768;

template <class Scalar>
struct Key {
  Scalar x, y, z;
};

/// The point with -0 replaced by 0, so that equal coordinates are equal bits.
Key<float> key_of(const std::array<float, 3>& p) { return {p[0] + 0.0F, p[1] + 0.0F, p[2] + 0.0F}; }
Key<double> key_of(const Vec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

std::uint64_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }
std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }

template <class Scalar>
bool same(const Key<Scalar>& a, const Key<Scalar>& b) {
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 32;
  h *= 0x9e3779b97f4a7c15ull;
  return h ^ (h >> 29);
}

template <class Scalar>
std::uint64_t hash(const Key<Scalar>& k) {
  return mix(mix(mix(bits(k.x)) + bits(k.y)) + bits(k.z));
}

template <class Scalar>
struct Record {
  Key<Scalar> key;
  std::uint32_t point;
};

/// For the points of one bucket, in their order: the first point with the same key.
template <class Scalar>
void weld_bucket(const Record<Scalar>* begin, const Record<Scalar>* end,
                 std::vector<std::uint32_t>& table, std::vector<std::uint32_t>& first_equal) {
  const auto count = static_cast<std::size_t>(end - begin);
  const std::size_t mask = std::bit_ceil(2 * count + 1) - 1;
  table.assign(mask + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t slot = hash(begin[i].key) & mask;
    while (table[slot] != 0 && !same(begin[table[slot] - 1].key, begin[i].key)) {
      slot = (slot + 1) & mask;
    }
    if (table[slot] == 0) table[slot] = static_cast<std::uint32_t>(i + 1);
    first_equal[begin[i].point] = begin[table[slot] - 1].point;
  }
}

template <class Scalar, class Point>
std::vector<std::uint32_t> first_equal_points(std::span<const Point> points,
                                              const RunContext& context) {
  const std::size_t n = points.size();
  const std::size_t buckets = std::min(std::bit_ceil(n / kBucketSize + 1), kMaxBuckets);
  const int shift = 64 - std::countr_zero(buckets);
  const auto bucket_of = [&](const Key<Scalar>& k) {
    return buckets == 1 ? std::size_t{0} : static_cast<std::size_t>(hash(k) >> shift);
  };
  const std::size_t chunk = std::max(kMinChunk, (n + kMaxChunks - 1) / kMaxChunks);
  const std::size_t chunks = (n + chunk - 1) / chunk;

  std::vector<std::uint32_t> place(chunks * buckets, 0);
  parallel_for(
      n, chunk,
      [&](std::size_t begin, std::size_t end) {
        std::uint32_t* counts = place.data() + begin / chunk * buckets;
        for (std::size_t i = begin; i < end; ++i) ++counts[bucket_of(key_of(points[i]))];
      },
      &context);
  std::vector<std::uint32_t> bucket_start(buckets + 1, 0);
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < buckets; ++b) {
    bucket_start[b] = sum;
    for (std::size_t c = 0; c < chunks; ++c) {
      std::uint32_t& p = place[c * buckets + b];
      const std::uint32_t count = p;
      p = sum;
      sum += count;
    }
  }
  bucket_start[buckets] = sum;

  const auto records = std::make_unique_for_overwrite<Record<Scalar>[]>(n);
  parallel_for(
      n, chunk,
      [&](std::size_t begin, std::size_t end) {
        std::uint32_t* next = place.data() + begin / chunk * buckets;
        for (std::size_t i = begin; i < end; ++i) {
          const Key<Scalar> k = key_of(points[i]);
          records[next[bucket_of(k)]++] = {k, static_cast<std::uint32_t>(i)};
        }
      },
      &context);

  std::vector<std::uint32_t> first_equal(n);
  parallel_for(
      buckets, 8,
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> table;
        for (std::size_t b = begin; b < end; ++b) {
          weld_bucket(records.get() + bucket_start[b], records.get() + bucket_start[b + 1], table,
                      first_equal);
        }
      },
      &context);
  return first_equal;
}

template <class Scalar, class Point>
Weld weld_points(std::span<const Point> points, const RunContext& context) {
  if (points.size() >= 0xffffffffull) {
    throw GeometryError("more than 4,294,967,294 points; split the model");
  }
  Weld w;
  w.vertex = first_equal_points<Scalar>(points, context);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < w.vertex.size(); ++i) {
    // A first point lies before all of its equals, so its vertex is known when they come.
    if (w.vertex[i] == i) {
      w.first.push_back(i);
      w.vertex[i] = count++;
    } else {
      w.vertex[i] = w.vertex[w.vertex[i]];
    }
  }
  return w;
}

}  // namespace

Weld weld(std::span<const std::array<float, 3>> points, const RunContext& context) {
  return weld_points<float>(points, context);
}

Weld weld(std::span<const Vec3> points, const RunContext& context) {
  return weld_points<double>(points, context);
}

}  // namespace burin
