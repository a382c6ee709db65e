// Files that styles name, written here byte by byte.
#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/converters/pictures.h>
#include <burin/drawing/path_data.h>

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace burin {
namespace {

class Pictures : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("burin_pictures_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& text) const {
    auto path = folder_ / "file";
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  // Pixels of 1 to 4 bytes, from the top.
  std::filesystem::path png(png_uint_32 width, png_uint_32 height, int kind, bool interlaced,
                            std::vector<png_byte> pixels) const {
    auto path = folder_ / "file.png";
    std::FILE* out = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, out);
    png_set_IHDR(png, info, width, height, 8, kind,
                 interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    png_write_info(png, info);
    std::vector<png_bytep> rows;
    for (png_uint_32 y = 0; y < height; ++y)
      rows.push_back(pixels.data() + y * (pixels.size() / height));
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    std::fclose(out);
    return path;
  }

  template <class F>
  static std::string refusal(const F& read) {
    try {
      read();
    } catch (const InputError& e) {
      return (e.line() > 0 ? std::to_string(e.line()) + ": " : "") + e.what();
    }
    return "it was read";
  }

  std::filesystem::path folder_;
};

TEST_F(Pictures, PngsHaveTheLightnessOfTheirPixelsBottomRowFirst) {
  for (const bool interlaced : {false, true}) {
    const Image image =
        read_png(png(3, 2, PNG_COLOR_TYPE_GRAY, interlaced, {0, 51, 255, 102, 153, 204}));
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 2);
    const float wanted[] = {0.4f, 0.6f, 0.8f, 0, 0.2f, 1};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(image.values[i], wanted[i], 1e-6);
  }
  const Image colours =
      read_png(png(3, 1, PNG_COLOR_TYPE_RGB, false, {255, 0, 0, 0, 255, 0, 0, 0, 255}));
  EXPECT_NEAR(colours.values[0], 0.2126, 1e-4);
  EXPECT_NEAR(colours.values[1], 0.7152, 1e-4);
  EXPECT_NEAR(colours.values[2], 0.0722, 1e-4);
  const Image glass = read_png(png(2, 1, PNG_COLOR_TYPE_GRAY_ALPHA, false, {0, 0, 0, 51}));
  EXPECT_NEAR(glass.values[0], 1, 1e-6);
  EXPECT_NEAR(glass.values[1], 0.8, 1e-6);
}

TEST_F(Pictures, ImagesAreBilinearAndRepeat) {
  const Image image{2, 2, {0, 1, 0.5f, 0.25f}};
  EXPECT_EQ(image.at(0.25, 0.25), 0);
  EXPECT_EQ(image.at(0.75, 0.25), 1);
  EXPECT_EQ(image.at(0.25, 0.75), 0.5);
  EXPECT_EQ(image.at(0.5, 0.25), 0.5);
  EXPECT_EQ(image.at(0.5, 0.5), 0.4375);
  EXPECT_EQ(image.at(-3.75, 5.25), 0);
  EXPECT_EQ(image.at(0, 0.25), 0.5);  // between the last column and the first
  EXPECT_TRUE(std::isnan(image.at(std::nan(""), 0)));
}

TEST_F(Pictures, DamagedPngsEndInOneLine) {
  EXPECT_EQ(refusal([&] { read_png(file("P5 1 1 255 x")); }), "the picture is no PNG; convert it");
  EXPECT_EQ(refusal([&] { read_png(file("")); }), "the picture is no PNG; convert it");
  EXPECT_THROW(read_png(folder_ / "none.png"), MissingFile);
  const auto whole = png(64, 64, PNG_COLOR_TYPE_GRAY, false, std::vector<png_byte>(64 * 64, 7));
  std::ifstream in(whole, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  for (std::size_t length = 8; length + 20 < bytes.size(); ++length) {
    EXPECT_TRUE(refusal([&] {
                  read_png(file(bytes.substr(0, length)));
                }).starts_with("the picture is damaged or cut off"))
        << length;
  }
  std::string wrong = bytes;
  wrong[40] = static_cast<char>(wrong[40] ^ 0x55);
  EXPECT_TRUE(refusal([&] { read_png(file(wrong)); }).starts_with("the picture is damaged"));
}

TEST_F(Pictures, TheSizeOfAPngIsTestedBeforeItIsDecoded) {
  // A header alone that says 100,000 x 100,000 pixels: had it been decoded, it would be cut off.
  const unsigned char header[] = {0x89, 'P', 'N',  'G',  '\r', '\n', 0x1a, '\n', 0,    0,
                                  0,    13,  'I',  'H',  'D',  'R',  0,    1,    0x86, 0xa0,
                                  0,    1,   0x86, 0xa0, 8,    0,    0,    0,    0};
  std::string text(reinterpret_cast<const char*>(header), sizeof header);
  const auto crc = [](const std::string& of) {
    std::uint32_t c = 0xffffffff;
    for (const char ch : of) {
      c ^= static_cast<unsigned char>(ch);
      for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >> 1) : c >> 1;
    }
    return ~c;
  }(text.substr(12));
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(crc >> shift);
  const std::string idat("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);
  EXPECT_EQ(refusal([&] { read_png(file(text + idat)); }),
            "the picture has 100000 x 100000 pixels, 16 million are the most; make it smaller");
}

TEST_F(Pictures, ShapesOfSvgsAreLinesWhereTheirTransformationsPutThem) {
  const auto lines = parse_path_data(read_svg_lines(file(R"svg(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg"><defs><path d="M0 0L9 9"/></defs>
<g transform="translate(10, 20) scale(2)"><path d="M0 0h1v1z"/></g>
<polygon points="0,0 1,0 1,1"/><polyline points="0 0 3 4"/>
<line x1="1" y1="2" x2="3" y2="4" transform="rotate(90)"/>
<rect x="1" y="2" width="3" height="4"/><circle cx="5" cy="6" r="2"/>
<path d="M0 0L1 1" display="none"/><text>no</text></svg>)svg")));
  ASSERT_EQ(lines.size(), 6);
  EXPECT_EQ(lines[0].curves[0][0], Vec2(10, 20));
  EXPECT_EQ(lines[0].curves[1][3], Vec2(12, 22));
  EXPECT_TRUE(lines[1].closed);
  EXPECT_FALSE(lines[2].closed);
  EXPECT_LT(glm::distance(lines[3].curves[0][0], Vec2(-2, 1)), 1e-6);
  EXPECT_EQ(lines[4].curves.size(), 4);
  for (const Vec2& p : flattened(lines[5], 1e-3))
    EXPECT_NEAR(glm::distance(p, Vec2(5, 6)), 2, 2e-3);
}

TEST_F(Pictures, SvgsThatDrawNothingOrAreNoneEndInOneLine) {
  EXPECT_THROW(read_svg_lines(folder_ / "none.svg"), MissingFile);
  EXPECT_EQ(refusal([&] { read_svg_lines(file("")); }), "1: bad XML (No document element found)");
  EXPECT_EQ(refusal([&] { read_svg_lines(file("<svg>\n<path d='M0 0L1 1'")); }).substr(0, 3),
            "2: ");
  EXPECT_EQ(refusal([&] { read_svg_lines(file("<html></html>")); }), "1: the file is no SVG");
  EXPECT_TRUE(refusal([&] {
                read_svg_lines(file("<svg><text>x</text></svg>"));
              }).starts_with("the file has no lines"));
  EXPECT_EQ(refusal([&] { read_svg_lines(file("<svg>\n\n<path d='M0 0L'/></svg>")); }),
            "3: <path>: column 6: the path ends where a number follows L");
  EXPECT_EQ(refusal([&] { read_svg_lines(file("<svg><polygon points='0,0 nan,1 2,2'/></svg>")); }),
            "1: <polygon>: 'nan,1 2,2' is no number");
  EXPECT_EQ(refusal([&] {
              read_svg_lines(file("<svg><g transform='spin(3)'><path d='M0 0L1 1'/></g></svg>"));
            }),
            "1: <g>: unknown transformation 'spin' of 1 numbers");
  std::string deep = "<svg>";
  for (int i = 0; i < 5000; ++i) deep += "<g>";
  for (int i = 0; i < 5000; ++i) deep += "</g>";
  EXPECT_EQ(refusal([&] { read_svg_lines(file(deep + "</svg>")); }),
            "1: <g>: elements are nested too deep");
  std::string wide = "<svg></svg>";
  wide.resize(9'000'000, ' ');
  EXPECT_EQ(refusal([&] { read_svg_lines(file(wide)); }),
            "the drawing has more than 8 MB; a motif or a template is smaller");
}

}  // namespace
}  // namespace burin
