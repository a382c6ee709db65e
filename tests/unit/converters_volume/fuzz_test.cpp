// Changed bytes, cut ends and repeated pieces of good files: each is read or refused in one line.
#include "volumes.h"

#include <burin_test/mutated.h>

#include <cstring>

namespace burin {
namespace {

constexpr std::string_view kSpice[] = {
    "-1",  "0",   "99999999999", "nan",  "1e999", "\n",       "\n\n",  ":", "=",    "\"",
    "256", " 3 ", "(1,0,0)",     "none", "gzip",  "\x1f\x8b", "LOCAL", "<", "##}\n"};

void fuzz(const std::string& name, const std::string& good, int rounds, std::uint64_t seed,
          const test::Files& others = {}) {
  ASSERT_NO_THROW(test::volume_of({{name, good}}));
  const test::Folder folder;
  for (const auto& [other, bytes] : others) folder.write(other, bytes);
  const Rng rng(seed);
  std::uint64_t n = 0;
  int read = 0, refused = 0;
  for (int i = 0; i < rounds; ++i) {
    const std::string path = folder.write(name, test::mutated(good, kSpice, rng, n));
    RunContext context;
    try {
      const Volume v = read_volume(path, {}, context);
      for (const float s : v.grid.samples) ASSERT_TRUE(std::isfinite(s));
      EXPECT_TRUE(std::isfinite(v.info.level));
      ++read;
    } catch (const InputError& e) {
      const std::string what = e.what();
      EXPECT_FALSE(what.empty());
      for (const char c : what) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << what;
      ++refused;
    }
  }
  EXPECT_EQ(read + refused, rounds);
  EXPECT_GT(refused, rounds / 10);
  EXPECT_GT(read, 0);
}

std::string floats() {
  return test::bytes_of_samples(test::some_samples(0.5), SampleType::F32, std::endian::little);
}

TEST(VolumeFuzz, Nrrd) {
  const std::string more =
      "space: LAS\nspace directions: (0,2,0) (-1,0,0) (0,0.5,3)\nspace origin: (1,2,3)\n";
  const auto little = std::endian::little;
  fuzz("a.nrrd", test::nrrd_header("float", little, "raw", more) + "\n" + floats(), 2000, 1);
  fuzz("a.nrrd",
       test::nrrd_header("float", little, "gzip", "spacings: 1 2 3\n") + "\n" +
           test::deflated(floats()),
       2000, 2);
  std::string text;
  for (const double v : test::some_samples()) text += fmt::format("{} ", v);
  fuzz("a.nrrd", test::nrrd_header("short", little, "text") + "\n" + text, 1000, 3);
  fuzz("a.nrrd.gz", test::deflated(test::nrrd_u8()), 1000, 4);
}

TEST(VolumeFuzz, MetaImage) {
  const std::string header =
      "ObjectType = Image\nNDims = 3\nElementSpacing = 1 2 3\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
      "CompressedData = {}\nDimSize = 4 3 2\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
  fuzz("a.mha", fmt::format(fmt::runtime(header), "False") + floats(), 2000, 5);
  fuzz("a.mha",
       fmt::format(fmt::runtime(header), "True") + test::deflated(floats(), test::Packing::Zlib),
       2000, 6);
}

TEST(VolumeFuzz, Inrimage) {
  std::string header =
      "#INRIMAGE-4#{\nXDIM=4\nYDIM=3\nZDIM=2\nVDIM=1\nTYPE=float\nPIXSIZE=32 bits\nCPU=decm\n"
      "VX=1\nVY=2\nVZ=3\n";
  header.resize(252, '\n');
  fuzz("a.inr", header + "##}\n" + floats(), 2000, 7);
}

TEST(VolumeFuzz, Nifti) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, const std::string& raw) {
    std::memcpy(header.data() + at, raw.data(), raw.size());
  };
  put(0, test::raw(std::int32_t{348}));
  put(344, "n+1");
  put(70, test::raw(std::int16_t{16}));
  const std::int16_t dims[] = {3, 4, 3, 2};
  for (std::size_t k = 0; k < 4; ++k) {
    put(40 + 2 * k, test::raw(dims[k]));
    put(76 + 4 * k, test::raw(1.5F));
  }
  put(108, test::raw(352.0F));
  fuzz("a.nii", header + floats(), 3000, 8);
  fuzz("a.nii.gz", test::deflated(header + floats()), 2000, 9);
}

TEST(VolumeFuzz, Vti) {
  std::string text;
  for (const double v : test::some_samples()) text += fmt::format("{} ", v);
  const std::string file =
      "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 3 0 2 0 1\" Spacing=\"1 2 4\">"
      "<Piece Extent=\"0 3 0 2 0 1\"><PointData><DataArray type=\"Float32\" Name=\"s\" ";
  const std::string end = "</DataArray></PointData></Piece></ImageData></VTKFile>";
  fuzz("a.vti", file + "format=\"ascii\">" + text + end, 2000, 10);
  std::string sized = test::raw(std::uint32_t{96}) + floats();
  fuzz("a.vti",
       file +
           "format=\"appended\" offset=\"0\"></DataArray></PointData></Piece></ImageData>"
           "<AppendedData encoding=\"raw\">_" +
           sized + "</AppendedData></VTKFile>",
       2000, 11);
}

}  // namespace
}  // namespace burin
