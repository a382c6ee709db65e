#include "volumes.h"

#include <cstring>

namespace burin {
namespace {

using test::bytes_of_samples;
using test::expect_error;
using test::expect_samples;
using test::expect_vector;
using test::some_samples;
using test::volume_of;

/// A header of version 1 or 2 with the fields that matter.
class Header {
 public:
  Header(int version, std::endian order, int type)
      : second_(version == 2), order_(order), bytes_(second_ ? 544 : 352, '\0') {
    put<std::int32_t>(0, second_ ? 540 : 348);
    std::memcpy(bytes_.data() + (second_ ? 4 : 344), second_ ? "n+2" : "n+1", 3);
    put<std::int16_t>(second_ ? 12 : 70, static_cast<std::int16_t>(type));
    dim(0, 3);
    dim(1, test::kNx);
    dim(2, test::kNy);
    dim(3, test::kNz);
    for (int k = 0; k < 4; ++k) real(second_ ? 104 : 76, k, 1);
    if (second_) {
      put<std::int64_t>(168, 544);
    } else {
      put<float>(108, 352);
    }
  }

  template <class T>
  void put(std::size_t at, T value) {
    const std::string raw = test::raw(value, order_);
    std::memcpy(bytes_.data() + at, raw.data(), raw.size());
  }
  void dim(std::size_t i, int n) {
    if (second_) {
      put<std::int64_t>(16 + 8 * i, n);
    } else {
      put<std::int16_t>(40 + 2 * i, static_cast<std::int16_t>(n));
    }
  }
  void real(std::size_t at, int index, double value) {
    const std::size_t place = at + static_cast<std::size_t>(index) * (second_ ? 8 : 4);
    if (second_) {
      put<double>(place, value);
    } else {
      put<float>(place, static_cast<float>(value));
    }
  }
  void code(std::size_t at, int value) {
    if (second_) {
      put<std::int32_t>(at, value);
    } else {
      put<std::int16_t>(at, static_cast<std::int16_t>(value));
    }
  }
  void pixdim(int i, double value) { real(second_ ? 104 : 76, i, value); }
  void slope(double a, double b) {
    real(second_ ? 176 : 112, 0, a);
    real(second_ ? 176 : 112, 1, b);
  }
  void units(int code_of_units) {
    if (second_) {
      put<std::int32_t>(500, code_of_units);
    } else {
      put<std::uint8_t>(123, static_cast<std::uint8_t>(code_of_units));
    }
  }
  void sform(const double (&rows)[12]) {
    code(second_ ? 348 : 254, 1);
    for (int i = 0; i < 12; ++i) real(second_ ? 400 : 280, i, rows[i]);
  }
  void qform(double b, double c, double d, Vec3 origin, double sign) {
    code(second_ ? 344 : 252, 1);
    pixdim(0, sign);
    const double q[] = {b, c, d, origin.x, origin.y, origin.z};
    for (int i = 0; i < 6; ++i) real(second_ ? 352 : 256, i, q[i]);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  bool second_;
  std::endian order_;
  std::string bytes_;
};

std::string file_of(const Header& header, SampleType type = SampleType::U8,
                    std::endian order = std::endian::little) {
  return header.bytes() + bytes_of_samples(some_samples(), type, order);
}

TEST(Nifti, EveryTypeOrderAndVersion) {
  const int codes[] = {256, 2, 4, 512, 8, 768, 1024, 1280, 16, 64};
  for (const int version : {1, 2}) {
    for (const SampleType type : test::kAllTypes) {
      for (const std::endian order : test::kBothOrders) {
        const std::string file =
            file_of({version, order, codes[static_cast<std::size_t>(type)]}, type, order);
        const Volume v = volume_of({{"a.nii", file}});
        expect_samples(v, some_samples());
        EXPECT_EQ(v.format, version == 1 ? "NIfTI-1" : "NIfTI-2");
        expect_samples(volume_of({{"a.nii.gz", test::deflated(file)}}), some_samples());
      }
    }
  }
}

TEST(Nifti, ScaleAndUnits) {
  for (const int version : {1, 2}) {
    Header header(version, std::endian::big, 2);
    header.slope(0.5, -3);
    header.units(3);
    header.pixdim(2, 250);
    const Volume v = volume_of({{"a.nii", file_of(header)}});
    std::vector<double> wanted;
    for (const double s : some_samples()) wanted.push_back(0.5 * s - 3);
    expect_samples(v, wanted);
    expect_vector(v.grid.steps[1], {0, 0.25, 0});
    EXPECT_EQ(v.info.min, -3);
  }
}

TEST(Nifti, SformGoesBeforeQform) {
  for (const int version : {1, 2}) {
    for (const std::endian order : test::kBothOrders) {
      Header header(version, order, 2);
      header.units(2);
      // A quarter about z, mirrored in the third axis.
      header.pixdim(1, 2);
      header.pixdim(2, 3);
      header.pixdim(3, 4);
      header.qform(0, 0, std::sqrt(0.5), {7, 8, 9}, -1);
      Volume v = volume_of({{"a.nii", file_of(header)}});
      expect_vector(v.grid.steps[0], {0, 2, 0});
      expect_vector(v.grid.steps[1], {-3, 0, 0});
      expect_vector(v.grid.steps[2], {0, 0, -4});
      expect_vector(v.grid.origin, {7, 8, 9});
      EXPECT_EQ(v.info.space, "right-anterior-superior");
      header.sform({-1, 0, 0.5, 90, 0, 1, 0, -120, 0, 0.25, 2, -70});
      v = volume_of({{"a.nii", file_of(header)}});
      expect_vector(v.grid.steps[0], {-1, 0, 0});
      expect_vector(v.grid.steps[1], {0, 1, 0.25});
      expect_vector(v.grid.steps[2], {0.5, 0, 2});
      expect_vector(v.grid.origin, {90, -120, -70});
    }
  }
}

TEST(Nifti, PairsAndAnalyze) {
  const auto little = std::endian::little;
  Header header(1, little, 4);
  header.put<float>(108, 0);
  const std::string data = bytes_of_samples(some_samples(), SampleType::I16, little);
  for (const bool analyze : {false, true}) {
    std::string bytes = header.bytes().substr(0, 348);
    std::memcpy(bytes.data() + 344, analyze ? "\0\0" : "ni1", analyze ? 2 : 3);
    if (analyze) bytes[346] = '\0';
    const test::Files files = {{"a.hdr", bytes}, {"a.img", data}};
    const Volume v = volume_of(files);
    expect_samples(v, some_samples());
    EXPECT_EQ(v.format, analyze ? "Analyze" : "NIfTI-1");
    expect_samples(volume_of({files[1], files[0]}), some_samples());
    expect_samples(volume_of({{"a.hdr", bytes}, {"a.img.gz", test::deflated(data)}}),
                   some_samples());
    expect_error({{"a.hdr", bytes}}, 0, "'a.img', is not there");
  }
  expect_error({{"a.img", data}}, 0, "does not begin with a NIfTI header");
}

TEST(Nifti, Errors) {
  const auto little = std::endian::little;
  const auto with = [&](auto change) {
    Header header(1, little, 2);
    change(header);
    return test::Files{{"a.nii", file_of(header)}};
  };
  expect_error(with([](Header& h) { h.dim(0, 2); }), 0, "2-D data");
  expect_error(with([](Header& h) { h.dim(3, 1); }), 0, "flat image");
  expect_error(with([](Header& h) { h.dim(2, -5); }), 0, "no size of a volume");
  expect_error(with([](Header& h) { h.dim(0, 9); }), 0, "no number of axes");
  expect_error(with([](Header& h) {
                 h.dim(0, 4);
                 h.dim(4, 30);
               }),
               0, "4-D data, 30 volumes");
  expect_error(with([](Header& h) { h.put<std::int16_t>(70, 128); }), 0, "128 (colours)");
  expect_error(with([](Header& h) { h.put<std::int16_t>(70, 32); }), 0, "complex");
  expect_error(with([](Header& h) { h.put<float>(108, 20); }), 0, "within the header");
  expect_error(with([](Header& h) { h.put<float>(108, -1e30F); }), 0, "no place");
  expect_error(with([](Header& h) { h.put<float>(108, 1e6F); }), 0, "truncated");
  expect_error(with([](Header& h) { h.dim(1, 30000); }), 0, "need 180000 bytes");
  expect_error(with([](Header& h) {
                 h.sform({1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0});
               }),
               0, "no three directions");
  expect_error({{"a.nii", std::string(100, 'x')}}, 0, "does not begin");
  const std::string packed = test::deflated(file_of({1, little, 2}));
  expect_error({{"a.nii.gz", packed.substr(0, packed.size() / 2)}}, 0, "ends too early");
  expect_error({{"a.nii.gz", packed.substr(0, 12)}}, 0, "ends too early");
}

}  // namespace
}  // namespace burin
