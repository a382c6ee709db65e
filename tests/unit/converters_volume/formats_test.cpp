// MetaImage, INRIA, VTK and raw.
#include "volumes.h"

namespace burin {
namespace {

using test::bytes_of_samples;
using test::expect_error;
using test::expect_samples;
using test::expect_vector;
using test::some_samples;
using test::volume_of;

std::string mha_header(const std::string& type, const std::string& more,
                       const std::string& file = "LOCAL") {
  return fmt::format(
      "ObjectType = Image\nNDims = 3\n{}DimSize = {} {} {}\nElementType = {}\nElementDataFile = "
      "{}\n",
      more, test::kNx, test::kNy, test::kNz, type, file);
}

TEST(MetaImage, EveryTypeInBothOrdersAndPacked) {
  const char* const names[] = {"MET_CHAR",  "MET_UCHAR", "MET_SHORT",     "MET_USHORT",
                               "MET_INT",   "MET_UINT",  "MET_LONG_LONG", "MET_ULONG_LONG",
                               "MET_FLOAT", "MET_DOUBLE"};
  for (const SampleType type : test::kAllTypes) {
    for (const std::endian order : test::kBothOrders) {
      const std::string name = names[static_cast<std::size_t>(type)];
      SCOPED_TRACE(name);
      const std::string msb = fmt::format("BinaryDataByteOrderMSB = {}\n",
                                          order == std::endian::big ? "True" : "False");
      const std::string bytes = bytes_of_samples(some_samples(), type, order);
      expect_samples(volume_of({{"a.mha", mha_header(name, msb) + bytes}}), some_samples());
      expect_samples(volume_of({{"a.mha", mha_header(name, msb + "CompressedData = True\n") +
                                              test::deflated(bytes, test::Packing::Zlib)}}),
                     some_samples());
    }
  }
}

TEST(MetaImage, DetachedTextAndPlace) {
  const auto little = std::endian::little;
  const std::string bytes = bytes_of_samples(some_samples(), SampleType::I16, little);
  expect_samples(volume_of({{"a.mhd", mha_header("MET_SHORT", "HeaderSize = 4\n", "a.raw")},
                            {"a.raw", "head" + bytes}}),
                 some_samples());
  expect_samples(volume_of({{"a.mhd", mha_header("MET_SHORT", "HeaderSize = -1\n", "a.raw")},
                            {"a.raw", "a long head" + bytes}}),
                 some_samples());
  std::string text;
  for (const double v : some_samples(0.25)) text += fmt::format("{} ", v);
  const Volume v =
      volume_of({{"a.mha", mha_header("MET_FLOAT",
                                      "BinaryData = False\nElementSpacing = 1 2 3\nOffset = 5 6 7\n"
                                      "TransformMatrix = 0 1 0 -1 0 0 0 0 1\n") +
                               text}});
  expect_samples(v, some_samples(0.25));
  expect_vector(v.grid.origin, {5, 6, 7});
  expect_vector(v.grid.steps[0], {0, 1, 0});
  expect_vector(v.grid.steps[1], {-2, 0, 0});
  expect_vector(v.grid.steps[2], {0, 0, 3});
}

TEST(MetaImage, Errors) {
  const auto bad = [](const std::string& text) { return test::Files{{"a.mha", text}}; };
  expect_error(bad("NDims = 2\nDimSize = 3 3\n"), 1, "2-D data is no volume");
  expect_error(bad("NDims = 4\nDimSize = 3 3 3 3\n"), 1, "4-D data");
  expect_error(bad("NDims = 3\nDimSize = 3 3 3\nElementNumberOfChannels = 3\n"), 3, "colours");
  expect_error(bad("NDims = 3\nDimSize = 3 3 3\nElementType = MET_LONG\n"), 3, "MET_LONG");
  expect_error(bad("NDims = 3\nDimSize = 3 3 3\nElementType = MET_UCHAR\n"), 0, "ElementDataFile");
  expect_error(bad("NDims = 3\nElementDataFile\n"), 2, "is no field");
  expect_error(bad(mha_header("MET_UCHAR", "CompressedData = perhaps\n") + "x"), 3,
               "True or False");
  expect_error(bad(mha_header("MET_UCHAR", "ElementSpacing = 1 0 1\n") + std::string(24, 'x')), 0,
               "no three directions");
  expect_error(bad(mha_header("MET_UCHAR", "", "a.mha")), 5, "names itself");
  expect_error(bad(mha_header("MET_UCHAR", "", "LIST")), 5, "several files");
  expect_error(bad(mha_header("MET_UCHAR", "") + "short"), 3, "need 24 bytes, 5 are there");
}

std::string inr(const std::string& type, int bits, const std::string& cpu,
                const std::string& more = "") {
  std::string header = fmt::format(
      "#INRIMAGE-4#{{\nXDIM={}\nYDIM={}\nZDIM={}\nVDIM=1\nTYPE={}\nPIXSIZE={} bits\nCPU={}\n{}",
      test::kNx, test::kNy, test::kNz, type, bits, cpu, more);
  header.resize(256 - 4, '\n');
  return header + "##}\n";
}

TEST(Inrimage, TypesOrdersAndPlace) {
  struct Row {
    SampleType type;
    const char* name;
    int bits;
  };
  for (const Row row :
       {Row{SampleType::U8, "unsigned fixed", 8}, Row{SampleType::I8, "signed fixed", 8},
        Row{SampleType::U16, "unsigned fixed", 16}, Row{SampleType::I32, "signed fixed", 32},
        Row{SampleType::F32, "float", 32}, Row{SampleType::F64, "float", 64}}) {
    for (const std::endian order : test::kBothOrders) {
      const char* cpu = order == std::endian::big ? "sun" : "decm";
      const std::string file =
          inr(row.name, row.bits, cpu) + bytes_of_samples(some_samples(), row.type, order);
      expect_samples(volume_of({{"a.inr", file}}), some_samples());
      expect_samples(volume_of({{"a.inr.gz", test::deflated(file)}}), some_samples());
    }
  }
  const Volume v = volume_of(
      {{"a.inr", inr("unsigned fixed", 8, "pc", "VX=0.5\nVY=2\nVZ=3.25\nTX=1\n") +
                     bytes_of_samples(some_samples(), SampleType::U8, std::endian::little)}});
  expect_vector({v.grid.steps[0].x, v.grid.steps[1].y, v.grid.steps[2].z}, {0.5, 2, 3.25});
  expect_vector(v.grid.origin, {1, 0, 0});
}

TEST(Inrimage, Errors) {
  expect_error({{"a.inr", inr("float", 16, "decm")}}, 7, "'16 bits' are not read");
  expect_error({{"a.inr", inr("packed", 8, "decm")}}, 6, "unsigned fixed");
  expect_error({{"a.inr", inr("float", 32, "vax")}}, 8, "byte order");
  expect_error({{"a.inr", inr("float", 32, "sun")}}, 4, "need 96 bytes, 0 are there");
  expect_error({{"a.inr", "#INRIMAGE-4#{\nXDIM=4\n"}}, 0, "no end");
  expect_error({{"a.inr", "#INRIMAGE-4#{\nXDIM 4\n##}"}}, 2, "is no field");
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto byte = i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0;
      bits = bits << 8 | byte;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return out;
}

std::string vti(const std::string& attributes, const std::string& array, const std::string& text,
                const std::string& more = "") {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" {}>\n<ImageData WholeExtent=\"0 {} 0 "
      "{} 1 {}\" Origin=\"1 2 3\" Spacing=\"1 2 4\">\n<Piece Extent=\"0 {} 0 {} 1 {}\">\n"
      "<PointData Scalars=\"s\">\n<DataArray Name=\"other\" type=\"Int8\" format=\"ascii\">1"
      "</DataArray>\n<DataArray Name=\"s\" {}>{}</DataArray>\n</PointData></Piece>\n"
      "</ImageData>\n{}</VTKFile>\n",
      attributes, test::kNx - 1, test::kNy - 1, test::kNz, test::kNx - 1, test::kNy - 1, test::kNz,
      array, text, more);
}

/// Two blocks and their sizes, as zlib data of VTK files begins.
std::string blocks(const std::string& bytes, bool encoded) {
  const std::size_t half = bytes.size() / 2;
  const std::string a = test::deflated(bytes.substr(0, half), test::Packing::Zlib);
  const std::string b = test::deflated(bytes.substr(half), test::Packing::Zlib);
  std::string header;
  for (const std::size_t n : {std::size_t{2}, half, bytes.size() - half, a.size(), b.size()}) {
    header += test::raw(static_cast<std::uint32_t>(n));
  }
  return encoded ? base64(header) + base64(a + b) : header + a + b;
}

TEST(Vti, AllWaysToHoldData) {
  const auto little = std::endian::little;
  const std::string bytes = bytes_of_samples(some_samples(0.5), SampleType::F32, little);
  const std::string sized = test::raw(static_cast<std::uint32_t>(bytes.size())) + bytes;
  const std::string zlib = "compressor=\"vtkZLibDataCompressor\"";
  const std::string type = "type=\"Float32\" ";
  std::string text;
  for (const double v : some_samples(0.5)) text += fmt::format("{} \n", v);
  const auto appended = [](const std::string& encoding, const std::string& data) {
    return "<AppendedData encoding=\"" + encoding + "\">\n _zz" + data + "</AppendedData>";
  };
  const std::string at = type + "format=\"appended\" offset=\"2\"";
  const std::vector<std::string> files = {
      vti("", type + "format=\"ascii\"", text),
      vti("byte_order=\"LittleEndian\"", type + "format=\"binary\"", "\n " + base64(sized) + "\n"),
      vti(zlib, type + "format=\"binary\"", blocks(bytes, true)),
      vti("", at, "", appended("raw", sized)),
      vti("", at, "", appended("base64", base64(sized))),
      vti(zlib, at, "", appended("raw", blocks(bytes, false))),
      vti(zlib, at, "", appended("base64", blocks(bytes, true))),
      vti("header_type=\"UInt64\" byte_order=\"BigEndian\"", type + "format=\"binary\"",
          base64(test::raw(static_cast<std::uint64_t>(bytes.size()), std::endian::big) +
                 bytes_of_samples(some_samples(0.5), SampleType::F32, std::endian::big)))};
  for (std::size_t i = 0; i < files.size(); ++i) {
    SCOPED_TRACE(i);
    const Volume v = volume_of({{"a.vti", files[i]}});
    expect_samples(v, some_samples(0.5));
    expect_vector(v.grid.origin, {1, 2, 7});
    expect_vector(v.grid.steps[1], {0, 2, 0});
  }
}

// Which of several arrays is drawn is the file's to say; where it does not, that is told.
TEST(Vti, SeveralArraysAreTold) {
  std::string values;
  for (const double v : some_samples(0.5)) values += fmt::format("{} ", v);
  std::string text = vti("", "type=\"Float32\" format=\"ascii\"", values);
  EXPECT_TRUE(volume_of({{"a.vti", text}}).diagnostics.entries().empty());
  const std::string other =
      "<DataArray Name=\"other\" type=\"Int8\" format=\"ascii\">1</DataArray>";
  text.erase(text.find(other), other.size());
  text.insert(text.find("</PointData>"), other);
  text.erase(text.find(" Scalars=\"s\""), 12);
  const Volume v = volume_of({{"a.vti", text}});
  expect_samples(v, some_samples(0.5));
  ASSERT_EQ(v.diagnostics.entries().size(), 1U);
  EXPECT_EQ(v.diagnostics.entries()[0].code, "volume.arrays");
  EXPECT_EQ(v.diagnostics.entries()[0].message,
            "of 2 arrays the first one, 's', is drawn; save the one to be drawn as Scalars");
}

TEST(Vti, Errors) {
  const auto bad = [](const std::string& text) { return test::Files{{"a.vti", text}}; };
  const std::string type = "type=\"Float32\" ";
  expect_error(bad("<VTKFile type=\"ImageData\"\n<"), 2, "export it again");
  expect_error(bad("<VTKFile type=\"PolyData\"></VTKFile>"), 0, "'PolyData', no ImageData");
  expect_error(bad(vti("", type + "NumberOfComponents=\"3\"", "1 2 3")), 0, "colours");
  expect_error(bad(vti("compressor=\"vtkLZ4DataCompressor\"", type, "")), 0, "vtkLZ4");
  expect_error(bad(vti("", "type=\"String\"", "")), 0, "no type of samples");
  expect_error(bad(vti("", type + "format=\"ascii\"", "1 2 3")), 0, "need 48 bytes");
  expect_error(bad(vti("", type + "format=\"binary\"", "AAAA")), 0, "ends too early");
  expect_error(bad(vti("", type + "format=\"binary\"", "A!AA")), 0, "no base64");
  expect_error(bad(vti("", type + "format=\"appended\" offset=\"7\"", "")), 0, "ends too early");
}

TEST(Raw, LayoutsOfText) {
  RawLayout l = parse_raw_layout("64x32x16");
  EXPECT_EQ(l.size, (std::array<std::int32_t, 3>{64, 32, 16}));
  EXPECT_EQ(l.type, SampleType::U8);
  EXPECT_FALSE(l.big_endian);
  l = parse_raw_layout("2x3x4:F32BE:1,2,2.5");
  EXPECT_EQ(l.type, SampleType::F32);
  EXPECT_TRUE(l.big_endian);
  expect_vector(l.spacing, {1, 2, 2.5});
  for (const char* bad :
       {"", "64", "64x64", "64x64x64x64", "64x64x1", "-4x4x4", "4x4x4:u7", "4x4x4:u8:1,1",
        "4x4x4:u8:1,1,0", "4x4x4:u8:1,1,1,1", "4x4x4:u8:1,1,1:x", "4x4x99999999999"}) {
    EXPECT_THROW(parse_raw_layout(bad), UsageError) << bad;
  }
}

TEST(Raw, IsReadAsItIsTold) {
  for (const SampleType type : test::kAllTypes) {
    VolumeReadOptions options;
    options.raw = RawLayout{{test::kNx, test::kNy, test::kNz}, type, true, {1, 2, 3}, 7};
    const std::string bytes = bytes_of_samples(some_samples(), type, std::endian::big);
    const Volume v = volume_of({{"a.raw", "1234567" + bytes}}, options);
    expect_samples(v, some_samples());
    expect_vector(v.grid.steps[2], {0, 0, 3});
    EXPECT_TRUE(v.diagnostics.empty());
    expect_error({{"a.vol", "123456" + bytes}}, 0, "truncated", options);
  }
  expect_error({{"a.raw", "1234"}}, 0, "`raw NXxNYxNZ");
}

TEST(Samples, ThatAreNoNumbersAreOutside) {
  std::vector<double> values = some_samples(10);
  values[3] = std::nan("");
  values[5] = std::numeric_limits<double>::infinity();
  values[7] = -1e300;
  VolumeReadOptions options;
  options.raw = RawLayout{{test::kNx, test::kNy, test::kNz}, SampleType::F64, false, Vec3(1), 0};
  const std::string bytes = bytes_of_samples(values, SampleType::F64, std::endian::little);
  const Volume v = volume_of({{"a.raw", bytes}}, options);
  ASSERT_EQ(v.diagnostics.entries().size(), 1u);
  EXPECT_EQ(v.diagnostics.entries()[0].code, "volume.not_finite");
  EXPECT_EQ(v.diagnostics.entries()[0].count, 3);
  for (const int i : {3, 5, 7}) values[static_cast<std::size_t>(i)] = 10;
  expect_samples(v, values);
  options.inside_above = false;
  EXPECT_EQ(volume_of({{"a.raw", bytes}}, options).grid.samples[3], static_cast<float>(v.info.max));
  expect_error({{"a.raw", bytes_of_samples(std::vector<double>(24, std::nan("")), SampleType::F64,
                                           std::endian::little)}},
               0, "no finite number", options);
}

}  // namespace
}  // namespace burin
