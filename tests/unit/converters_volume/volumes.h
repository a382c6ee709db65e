#pragma once
/// Volumes as the bytes of files, and reading them back.

#include <burin/base/error.h>
#include <burin/converters/volume_reader.h>

#include <burin_test/folder.h>
#include <burin_test/mesh_files.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

/// 4 x 3 x 2, all different along all axes, and whole so that every type holds them.
inline constexpr int kNx = 4, kNy = 3, kNz = 2;
inline int sample_at(int i) { return (i * 37 + i * i) % 101; }
inline std::vector<double> some_samples(double shift = 0) {
  std::vector<double> values;
  for (int i = 0; i < kNx * kNy * kNz; ++i) values.push_back(sample_at(i) + shift);
  return values;
}

template <class T>
std::string packed_as(const std::vector<double>& values, std::endian order) {
  std::string bytes;
  for (const double v : values) bytes += raw(static_cast<T>(v), order);
  return bytes;
}

inline std::string bytes_of_samples(const std::vector<double>& values, SampleType type,
                                    std::endian order) {
  switch (type) {
    case SampleType::I8:
      return packed_as<std::int8_t>(values, order);
    case SampleType::U8:
      return packed_as<std::uint8_t>(values, order);
    case SampleType::I16:
      return packed_as<std::int16_t>(values, order);
    case SampleType::U16:
      return packed_as<std::uint16_t>(values, order);
    case SampleType::I32:
      return packed_as<std::int32_t>(values, order);
    case SampleType::U32:
      return packed_as<std::uint32_t>(values, order);
    case SampleType::I64:
      return packed_as<std::int64_t>(values, order);
    case SampleType::U64:
      return packed_as<std::uint64_t>(values, order);
    case SampleType::F32:
      return packed_as<float>(values, order);
    case SampleType::F64:
      break;
  }
  return packed_as<double>(values, order);
}

enum class Packing { Gzip, Zlib };

inline std::string deflated(const std::string& bytes, Packing packing = Packing::Gzip) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, packing == Packing::Gzip ? 15 + 16 : 15, 8,
               Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64, '\0');
  std::string in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

/// Files of one volume; the first is the one that is read.
using Files = std::vector<std::pair<std::string, std::string>>;

inline Volume volume_of(const Files& files, const VolumeReadOptions& options = {}) {
  const Folder folder;
  for (const auto& [name, bytes] : files) folder.write(name, bytes);
  RunContext context;
  return read_volume(folder / files.front().first, options, context);
}

inline void expect_samples(const Volume& volume, const std::vector<double>& wanted) {
  EXPECT_EQ(volume.grid.size, (std::array<std::int32_t, 3>{kNx, kNy, kNz}));
  ASSERT_EQ(volume.grid.samples.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(volume.grid.samples[i], static_cast<float>(wanted[i])) << i;
  }
}

inline void expect_vector(Vec3 a, Vec3 b) {
  EXPECT_LE(glm::distance(a, b), 1e-6 * (1 + glm::length(b)))
      << a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z;
}

/// The files are refused, at this line (0: none), in one line that holds `part`.
inline void expect_error(const Files& files, std::int64_t line, const std::string& part,
                         const VolumeReadOptions& options = {}) {
  try {
    volume_of(files, options);
    ADD_FAILURE() << "was read; expected: " << part;
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_FALSE(e.file().empty()) << what;
    EXPECT_EQ(e.line(), line) << what;
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

inline constexpr SampleType kAllTypes[] = {
    SampleType::I8,  SampleType::U8,  SampleType::I16, SampleType::U16, SampleType::I32,
    SampleType::U32, SampleType::I64, SampleType::U64, SampleType::F32, SampleType::F64};
inline constexpr std::endian kBothOrders[] = {std::endian::little, std::endian::big};

/// Without the data and the empty line.
inline std::string nrrd_header(const std::string& type, std::endian order,
                               const std::string& encoding, const std::string& more = "") {
  return fmt::format(
      "NRRD0004\n# a comment\ntype: {}\ndimension: 3\nsizes: {} {} {}\nendian: {}\nencoding: "
      "{}\n{}",
      type, kNx, kNy, kNz, order == std::endian::big ? "big" : "little", encoding, more);
}

inline std::string nrrd_u8(const std::string& more = "") {
  return nrrd_header("uchar", std::endian::little, "raw", more) + "\n" +
         bytes_of_samples(some_samples(), SampleType::U8, std::endian::little);
}

}  // namespace burin::test
