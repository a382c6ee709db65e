#include "patches.h"

#include "split.h"
#include "words.h"

#include <algorithm>
#include <iterator>

namespace burin::irit {
namespace {

/// What a header of Geomview says: [C]BEZ<degree u><degree v><dimension>[_ST] or [ST]BBP.
struct Header {
  int degree_u = 3, degree_v = 3;
  bool rational = false;
  int extras = 0;  // numbers after each patch: colours, texture coordinates of its corners
};

std::optional<Header> header_of(std::string_view word) {
  constexpr int kTexture = 8, kColors = 16;
  Header header;
  if (word == "BBP") return header;
  header.extras = kTexture;
  if (word == "STBBP") return header;
  header.extras = word.starts_with('C') ? kColors : 0;
  if (word.starts_with('C')) word.remove_prefix(1);
  if (word.ends_with("_ST")) {
    header.extras += kTexture;
    word.remove_suffix(3);
  }
  const auto digit = [&](std::size_t i) { return word[i] - '0'; };
  if (word.size() != 6 || !word.starts_with("BEZ")) return std::nullopt;
  if (digit(3) < 1 || digit(3) > 6 || digit(4) < 1 || digit(4) > 6) return std::nullopt;
  if (digit(5) != 3 && digit(5) != 4) return std::nullopt;
  header.degree_u = digit(3);
  header.degree_v = digit(4);
  header.rational = digit(5) == 4;
  return header;
}

// The patches are one part: where one point lies so many times farther out than is usual, nothing
// of the others is left on any sheet.
constexpr double kWildRatio = 1e7;

void check_extent(const Source& source, const std::vector<double>& reach) {
  std::vector<double> sorted;
  std::ranges::copy_if(reach, std::back_inserter(sorted), [](double r) { return r > 0; });
  if (sorted.empty()) return;
  std::ranges::sort(sorted);
  if (sorted.back() > kWildRatio * sorted[sorted.size() / 2]) {
    source.fail(
        "a point of the patches lies ten million times farther out than is usual there; the "
        "file is damaged");
  }
}

/// The file has u fastest, patches v.
HomogeneousPatch read_patch(const Source& source, Words& in, const Header& header) {
  HomogeneousPatch patch{header.degree_u, header.degree_v, {}};
  const auto nu = static_cast<std::size_t>(header.degree_u + 1);
  const auto nv = static_cast<std::size_t>(header.degree_v + 1);
  patch.points.resize(nu * nv);
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t i = 0; i < nu; ++i) {
      glm::dvec4& p = patch.points[i * nv + j];
      for (int k = 0; k < 3; ++k) p[k] = number(source, in, "a coordinate");
      p.w = header.rational ? number(source, in, "a weight") : 1;
    }
  }
  for (int k = 0; k < header.extras; ++k) number(source, in, "a colour or texture coordinate");
  return patch;
}

}  // namespace

bool is_geomview(std::string_view text) { return header_of(Words(text).next()).has_value(); }

std::vector<NurbsData> read_geomview(const Source& source) {
  Words in(source.bytes());
  const std::string_view word = in.next();
  const std::optional<Header> header = header_of(word);
  if (!header) expected(source, word, "a header of Bezier patches, as BBP or BEZ334");
  std::vector<NurbsData> patches;
  std::vector<double> reach;
  for (;;) {
    source.context().check();
    Words ahead = in;
    const std::string_view first = ahead.next();
    if (first.empty()) break;
    const HomogeneousPatch patch = read_patch(source, in, *header);
    // At infinity, too: the size of a direction counts like that of a place.
    for (const glm::dvec4& p : patch.points) reach.push_back(glm::length(Vec3(p)));
    if (!append_positive(patch, patches)) {
      fail_at(source, first.data(),
              "this patch has points at infinity (weights that are not positive); export it again");
    }
  }
  check_extent(source, reach);
  return patches;
}

}  // namespace burin::irit
