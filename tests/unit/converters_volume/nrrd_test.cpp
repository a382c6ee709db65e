#include "volumes.h"

namespace burin {
namespace {

using test::bytes_of_samples;
using test::expect_error;
using test::expect_samples;
using test::expect_vector;
using test::nrrd_header;
using test::nrrd_u8;
using test::some_samples;
using test::volume_of;

const char* const kNrrdTypes[] = {"signed char", "uchar", "short", "unsigned short",
                                  "int",         "uint",  "int64", "unsigned long long int",
                                  "float",       "double"};

TEST(Nrrd, EveryTypeInBothOrders) {
  for (const SampleType type : test::kAllTypes) {
    for (const std::endian order : test::kBothOrders) {
      const std::string name = kNrrdTypes[static_cast<std::size_t>(type)];
      SCOPED_TRACE(name);
      const std::string bytes = bytes_of_samples(some_samples(), type, order);
      const Volume v = volume_of({{"a.nrrd", nrrd_header(name, order, "raw") + "\n" + bytes}});
      expect_samples(v, some_samples());
      EXPECT_EQ(v.format, "NRRD");
      EXPECT_EQ(v.info.min, 0);
      EXPECT_TRUE(v.diagnostics.empty());
      const std::string packed = test::deflated(bytes);
      expect_samples(volume_of({{"a.nrrd", nrrd_header(name, order, "gzip") + "\n" + packed}}),
                     some_samples());
    }
  }
}

TEST(Nrrd, NegativeAndFractionalValues) {
  const auto values = some_samples(-50);
  const std::string bytes = bytes_of_samples(values, SampleType::I16, std::endian::big);
  expect_samples(
      volume_of({{"a.nrrd", nrrd_header("short", std::endian::big, "raw") + "\n" + bytes}}),
      values);
  const auto parts = some_samples(0.125);
  expect_samples(
      volume_of({{"a.nrrd", nrrd_header("double", std::endian::big, "raw") + "\n" +
                                bytes_of_samples(parts, SampleType::F64, std::endian::big)}}),
      parts);
}

TEST(Nrrd, TextAndHex) {
  std::string text, hex;
  for (const double v : some_samples(0.5)) text += fmt::format("{}\n ", v);
  for (const double v : some_samples()) hex += fmt::format("{:02x}", static_cast<int>(v));
  hex.insert(9, "\n");
  const auto little = std::endian::little;
  expect_samples(volume_of({{"a.nrrd", nrrd_header("float", little, "ascii") + "\n" + text}}),
                 some_samples(0.5));
  expect_samples(volume_of({{"a.nrrd", nrrd_header("uchar", little, "hex") + "\n" + hex}}),
                 some_samples());
}

TEST(Nrrd, DetachedWithSkips) {
  const auto little = std::endian::little;
  const std::string bytes = bytes_of_samples(some_samples(), SampleType::U16, little);
  const auto header = [&](const std::string& encoding, const std::string& more) {
    return nrrd_header("ushort", little, encoding, more);
  };
  expect_samples(volume_of({{"a.nhdr", header("raw", "data file: a.raw\n")}, {"a.raw", bytes}}),
                 some_samples());
  expect_samples(
      volume_of({{"a.nhdr", header("raw", "line skip: 2\nbyte skip: 3\ndatafile: ./a.raw\n\n")},
                 {"a.raw", "one\ntwo\nxyz" + bytes}}),
      some_samples());
  expect_samples(volume_of({{"a.nhdr", header("raw", "byte skip: -1\ndata file: a.raw\n")},
                            {"a.raw", "who knows how long" + bytes}}),
                 some_samples());
  expect_samples(volume_of({{"a.nhdr", header("gz", "byte skip: 5\ndata file: a.raw.gz\n")},
                            {"a.raw.gz", test::deflated("12345" + bytes)}}),
                 some_samples());
}

TEST(Nrrd, AWholeFilePacked) {
  expect_samples(volume_of({{"a.nrrd.gz", test::deflated(nrrd_u8())}}), some_samples());
  const std::string twice =
      nrrd_header("uchar", std::endian::little, "gzip") + "\n" +
      test::deflated(bytes_of_samples(some_samples(), SampleType::U8, std::endian::little));
  expect_samples(volume_of({{"a.nrrd.gz", test::deflated(twice)}}), some_samples());
}

TEST(Nrrd, PlaceInSpace) {
  Volume v = volume_of({{"a.nrrd", nrrd_u8("spacings: 1 2.5 -4\naxis mins: 3 nan -1\n")}});
  expect_vector(v.grid.steps[1], {0, 2.5, 0});
  expect_vector(v.grid.steps[2], {0, 0, -4});
  expect_vector(v.grid.origin, {3, 0, -1});
  v = volume_of(
      {{"a.nrrd", nrrd_u8("axis mins: 0 0 0\naxis maxs: 8 6 4\ncenters: cell node cell\n")}});
  expect_vector(v.grid.origin, {1, 0, 1});
  expect_vector({v.grid.steps[0].x, v.grid.steps[1].y, v.grid.steps[2].z}, {2, 3, 2});
  const std::string tilted = "space directions: (0, 2,0) (-1,0,0) (0,0.5,3)\n";
  v = volume_of({{"a.nrrd", nrrd_u8("space: RAS\nspace origin: (10,20,30)\nspace units: \"cm\" "
                                    "\"cm\" \"cm\"\n" +
                                    tilted)}});
  expect_vector(v.grid.steps[0], {0, 20, 0});
  expect_vector(v.grid.steps[1], {-10, 0, 0});
  expect_vector(v.grid.steps[2], {0, 5, 30});
  expect_vector(v.grid.origin, {100, 200, 300});
  EXPECT_EQ(v.info.space, "right-anterior-superior");
  expect_vector(v.info.bounds.max, {100, 200 + 60 + 5, 330});
  // Left-handed by name: one coordinate changes its sign.
  v = volume_of(
      {{"a.nrrd", nrrd_u8("space: left-anterior-superior\nspace origin: (10,20,30)\n" + tilted)}});
  expect_vector(v.grid.steps[1], {1, 0, 0});
  expect_vector(v.grid.origin, {-10, 20, 30});
}

TEST(Nrrd, AxesOfOneSampleAreNone) {
  const std::string header = fmt::format(
      "NRRD0001\ntype: uint8_t\ndimension: 4\nsizes: 1 {} {} {}\nspacings: nan 1 2 3\nencoding: "
      "raw\nkey:=value\n\n",
      test::kNx, test::kNy, test::kNz);
  const Volume v = volume_of(
      {{"a.nrrd", header + bytes_of_samples(some_samples(), SampleType::U8, std::endian::little)}});
  expect_samples(v, some_samples());
  expect_vector({v.grid.steps[0].x, v.grid.steps[1].y, v.grid.steps[2].z}, {1, 2, 3});
}

TEST(Nrrd, BytesBehindTheDataAreTold) {
  const Volume v = volume_of({{"a.nrrd", nrrd_u8() + "tail"}});
  expect_samples(v, some_samples());
  ASSERT_EQ(v.diagnostics.entries().size(), 1u);
  EXPECT_EQ(v.diagnostics.entries()[0].code, "volume.trailing_bytes");
  EXPECT_EQ(v.diagnostics.entries()[0].count, 4);
}

TEST(Nrrd, ErrorsNameTheLine) {
  const auto header = [](const std::string& text) {
    return test::Files{{"a.nrrd", "NRRD0004\n" + text + "\n\n"}};
  };
  const std::string sizes = "dimension: 3\nsizes: 4 3 2\n";
  expect_error(header("type uchar"), 2, "'type uchar' is no field");
  expect_error(header("dimension: 3\nsizes: 4 3"), 3, "takes 3 numbers, not 2");
  expect_error(header("dimension: 3\nsizes: 4 x 2"), 3, "'x' is no whole number");
  expect_error(header("dimension: 3\ndimension: 3"), 3, "second time");
  expect_error(header("dimension: 2\nsizes: 40 30"), 3, "2-D data is no volume");
  expect_error(header("dimension: 4\nsizes: 3 4 3 2"), 3, "vectors, colours or several volumes");
  expect_error(header(sizes + "encoding: raw"), 0, "has no 'type'");
  expect_error(header(sizes + "type: block\nencoding: raw"), 4, "'block' is no type");
  expect_error(header(sizes + "type: float\nencoding: bzip2"), 5, "save the file as raw or gzip");
  expect_error(header(sizes + "type: float\nencoding: raw"), 0, "has no 'endian'");
  expect_error(header(sizes + "type: uchar\nencoding: raw\nspace directions: (1,0,0) none (0,0,1)"),
               6, "no direction in space");
  expect_error(header(sizes + "type: uchar\nencoding: raw\nspace directions: (1,0,0) (0,1,0)"), 6,
               "2 directions for 3 axes");
  expect_error(header(sizes + "type: uchar\nencoding: raw\ndata file: a.nrrd"), 6, "names itself");
  expect_error(header(sizes + "type: uchar\nencoding: raw\ndata file: b.raw"), 6, "is not there");
  expect_error(header(sizes + "type: uchar\nencoding: raw\ndata file: b%03d.raw 1 9 1"), 6,
               "several files");
  expect_error({{"a.nrrd", "NRRD0004\ndimension: 3\nsizes: 4 3 2\ntype: uchar\nencoding: raw\n"}},
               0, "truncated");
  expect_error({{"a.nrrd", "no magic at all"}}, 0, "NRRD000");
}

TEST(Nrrd, SizesAreHeldAgainstTheFile) {
  const auto header = [](const std::string& sizes, const std::string& encoding) {
    return test::Files{{"a.nrrd", "NRRD0004\ndimension: 3\nsizes: " + sizes +
                                      "\ntype: uchar\nencoding: " + encoding + "\n\nabcdef"}};
  };
  expect_error(header("4 3 2", "raw"), 3, "need 24 bytes, 6 are there");
  expect_error(header("1000 1000 1000", "raw"), 3, "truncated");
  expect_error(header("100 100 100", "gzip"), 3, "truncated");
  expect_error(header("4 3 2", "gzip"), 0, "compressed data");
  expect_error(header("4 3 2", "ascii"), 3, "need 48 bytes");
  expect_error(header("4 3 1", "raw"), 3, "flat image");
  expect_error(header("1000000 1000000 1000000", "raw"), 3, "quarter of this machine's memory");
  expect_error(header("9000000000 2 2", "raw"), 3, "more samples in a row");
  expect_error(header("4 3 -2", "raw"), 3, "is no number of samples");
  expect_error(header("99999999999999999999 3 2", "raw"), 3, "no whole number");
}

TEST(Nrrd, BrokenCompression) {
  const auto little = std::endian::little;
  const std::string packed =
      test::deflated(bytes_of_samples(some_samples(), SampleType::F64, little));
  const std::string header = nrrd_header("double", little, "gzip") + "\n";
  expect_error({{"a.nrrd", header + packed.substr(0, packed.size() / 2)}}, 0, "ends too early");
  std::string damaged = packed;
  damaged[damaged.size() / 2] ^= 0x55;
  damaged[damaged.size() / 2 + 1] ^= 0x55;
  expect_error({{"a.nrrd", header + damaged}}, 0, "damaged");
  // Unpacked no further than the samples reach: a bomb stays folded.
  const std::string bomb = test::deflated(bytes_of_samples(some_samples(), SampleType::U8, little) +
                                          std::string(std::size_t{64} << 20, '\0'));
  expect_samples(volume_of({{"a.nrrd", nrrd_header("uchar", little, "gzip") + "\n" + bomb}}),
                 some_samples());
}

}  // namespace
}  // namespace burin
