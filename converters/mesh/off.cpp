#include "binary.h"
#include "byte_order_mark.h"
#include "formats.h"
#include "groups.h"
#include "text.h"
#include "texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

// Own code: the readers of OpenMesh and of CGAL's stream operators give no line of an error.
namespace burin {
namespace {

/// What the word before the counts says about the vertices.
struct OffHeader {
  bool extras = false;       // colours, normals or texture coordinates follow the coordinates
  bool colored = false;      // it is colours alone that do
  bool textured = false;     // the last two of them are texture coordinates
  bool homogeneous = false;  // a fourth coordinate divides the others
  bool binary = false;
};

class OffReader {
 public:
  explicit OffReader(const Source& source)
      : source_(source), text_(source, byte_order_mark(source.bytes())) {}
  MeshFile read();

 private:
  void header();
  void counts();
  void skip_edge_count();
  bool vertices_fill_lines() const;
  void vertices();
  glm::vec2 last_two_of_line();
  std::optional<Rgba> color_of_line();
  void faces();
  void finish(const char* format);
  void read_binary();
  bool try_binary(std::endian order, bool colour_counts);

  const Source& source_;
  TextCursor text_;
  OffHeader header_;
  std::size_t vertex_count_ = 0, face_count_ = 0;
  std::int64_t short_faces_ = 0;
  MeshFile file_;
  PolygonSoup soup_;
  std::vector<glm::vec2> vertex_texture_;
  std::vector<std::optional<Rgba>> vertex_colors_;
  FaceLooks face_looks_;
};

void OffReader::header() {
  text_.skip_space('#');
  const char* p = text_.where();
  const bool counts_follow =
      text_.left() > 1 && is_digit(*p) && (is_digit(p[1]) || is_blank(p[1]) || is_line_end(p[1]));
  if (counts_follow) return;  // the header word is optional
  const auto skip = [&](std::string_view word) {
    const bool found = std::string_view(p, text_.left()).substr(0, word.size()) == word;
    if (found) p += word.size();
    return found;
  };
  header_.textured = skip("ST");
  header_.extras = header_.textured;
  const bool colors = skip("C"), normals = skip("N");
  header_.extras |= colors || normals;
  header_.colored = colors && !normals && !header_.textured;
  header_.homogeneous = skip("4");
  const bool n_dimensional = skip("n");
  if (!skip("OFF")) {
    text_.fail("an OFF file begins with OFF, this one with " + in_quotes(text_.token()));
  }
  text_.skip(static_cast<std::size_t>(p - text_.where()));
  text_.skip_blanks();
  if (text_.peek() == 'B' && text_.token() == "BINARY") {
    header_.binary = true;
    return;
  }
  if (n_dimensional) {
    text_.skip_space('#');
    if (text_.integer("the dimension") != 3) text_.fail("only three-dimensional nOFF can be read");
  }
}

/// The count of edges may stand on the line of the others, on its own line or nowhere.
void OffReader::skip_edge_count() {
  text_.skip_blanks();
  if (!text_.at_line_end() && text_.peek() != '#') return text_.next_line();
  TextCursor ahead = text_;
  ahead.skip_space('#');
  const std::string_view line = ahead.rest_of_line();
  const bool alone = !line.empty() && std::ranges::all_of(line, is_digit);
  if (alone && face_count_ + vertex_count_ > 0) {
    text_.skip_space('#');
    text_.next_line();
  }
}

void OffReader::counts() {
  constexpr std::size_t kVertexBytes = 5, kFaceBytes = 2;  // "0 0 0" and "0\n"
  text_.skip_space('#');
  vertex_count_ = text_.count("the number of vertices", kVertexBytes);
  text_.skip_space('#');
  face_count_ = text_.count("the number of faces", kFaceBytes);
  skip_edge_count();
}

/// Whether each vertex has its own line, so that what follows the coordinates there is no next
/// vertex.
bool OffReader::vertices_fill_lines() const {
  if (header_.extras) return true;
  TextCursor ahead = text_;
  ahead.skip_space('#');
  for (int i = 0; i < 3; ++i) {
    ahead.skip_blanks();
    if (ahead.token().empty()) return false;
  }
  ahead.skip_blanks();
  if (ahead.at_line_end() || ahead.peek() == '#') return false;
  const std::string_view rest(text_.where(), text_.left());
  return static_cast<std::size_t>(std::ranges::count_if(rest, is_line_end)) >=
         vertex_count_ + face_count_;
}

glm::vec2 OffReader::last_two_of_line() {
  glm::vec2 uv(kNoTexture);
  for (text_.skip_blanks(); !text_.at_line_end() && text_.peek() != '#'; text_.skip_blanks()) {
    uv = {uv.y, texture_coordinate(text_.token())};
  }
  return uv;
}

/// Three or four numbers, red, green, blue and opacity: up to 255 where they are whole, else shares
/// of
/// 1. A single one is a place in a table that no file has.
std::optional<Rgba> OffReader::color_of_line() {
  std::array<double, 4> values{};
  std::size_t count = 0;
  bool whole = true;
  for (text_.skip_blanks(); !text_.at_line_end() && text_.peek() != '#'; text_.skip_blanks()) {
    const std::string_view word = text_.token();
    if (count == values.size() || !parse_double(word, values[count])) return std::nullopt;
    whole = whole && word.find_first_of(".eE") == word.npos;
    ++count;
  }
  if (count < 3) return std::nullopt;
  Rgba color{0, 0, 0, 255};
  for (std::size_t i = 0; i < count; ++i) color[i] = channel(whole ? values[i] / 255 : values[i]);
  return color;
}

void OffReader::vertices() {
  const bool by_line = vertices_fill_lines();
  soup_.positions.reserve(vertex_count_);
  for (std::size_t i = 0; i < vertex_count_; ++i) {
    source_.context().check();
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      text_.skip_space('#');
      p[k] = text_.number("a coordinate");
    }
    if (header_.homogeneous) {
      text_.skip_space('#');
      p /= text_.number("a coordinate");
    }
    soup_.positions.push_back(p);
    if (header_.textured) vertex_texture_.push_back(last_two_of_line());
    if (header_.colored) vertex_colors_.push_back(color_of_line());
    if (by_line) text_.next_line();
  }
}

void OffReader::faces() {
  soup_.offsets.reserve(face_count_ + 1);
  soup_.indices.reserve(3 * face_count_);
  for (std::size_t f = 0; f < face_count_; ++f) {
    source_.context().check();
    text_.skip_space('#');
    const std::size_t corners = text_.count("the number of corners", 1);
    for (std::size_t c = 0; c < corners; ++c) {
      text_.skip_space('#');
      const char* begin = text_.where();
      const std::int64_t v = text_.integer("the index of a vertex");
      if (v < 0 || static_cast<std::uint64_t>(v) >= vertex_count_) {
        source_.fail_at_line(begin,
                             fmt::format("the face refers to vertex {}, the file holds 0 to {}; it "
                                         "is damaged, export it again",
                                         v, static_cast<std::int64_t>(vertex_count_) - 1));
      }
      soup_.indices.push_back(static_cast<std::uint32_t>(v));
    }
    if (corners < 3) {
      soup_.indices.resize(soup_.offsets.back());
      ++short_faces_;
    } else {
      soup_.offsets.push_back(soup_.indices.size());
    }
    face_looks_.add(color_of_line(), corners < 3 ? 0 : 1);
    text_.next_line();
  }
}

void OffReader::finish(const char* format) {
  if (soup_.polygon_count() == 0) {
    source_.fail(
        fmt::format("holds {} vertices but no face of three corners; export it as a surface",
                    soup_.positions.size()));
  }
  file_.format = format;
  if (short_faces_ > 0) {
    file_.diagnostics.add(Severity::Warning, "off.short_faces", short_faces_,
                          "faces of fewer than three corners were left out");
  }
  if (!vertex_texture_.empty()) {
    for (const std::uint32_t v : soup_.indices) soup_.texture.push_back(vertex_texture_[v]);
  }
  add_use(face_looks_.any() ? face_looks_ : looks_by_vertices(soup_, vertex_colors_), file_);
  file_.objects.push_back(std::move(soup_));
}

/// Binary OFF comes in both byte orders and with or without a count of colours after each face;
/// returns whether the file is of this kind.
bool OffReader::try_binary(std::endian order, bool colour_counts) {
  BinaryCursor in(source_, static_cast<std::size_t>(text_.where() - source_.bytes().data()), order);
  soup_ = {};
  short_faces_ = 0;
  if (!in.has(12)) return false;
  vertex_count_ = in.get<std::uint32_t>();
  face_count_ = in.get<std::uint32_t>();
  in.get<std::uint32_t>();
  if (!in.has(12.0 * static_cast<double>(vertex_count_) + 4.0 * static_cast<double>(face_count_))) {
    return false;
  }
  soup_.positions.reserve(vertex_count_);
  for (std::size_t i = 0; i < vertex_count_; ++i) {
    const float x = in.get<float>(), y = in.get<float>(), z = in.get<float>();
    soup_.positions.emplace_back(x, y, z);
  }
  for (std::size_t f = 0; f < face_count_; ++f) {
    source_.context().check();
    if (!in.has(4)) return false;
    const std::uint32_t corners = in.get<std::uint32_t>();
    if (!in.has(4.0 * corners)) return false;
    for (std::uint32_t c = 0; c < corners; ++c) {
      const std::uint32_t v = in.get<std::uint32_t>();
      if (v >= vertex_count_) return false;
      soup_.indices.push_back(v);
    }
    if (corners < 3) {
      soup_.indices.resize(soup_.offsets.back());
      ++short_faces_;
    } else {
      soup_.offsets.push_back(soup_.indices.size());
    }
    if (!colour_counts) continue;
    if (!in.has(4)) return false;
    const std::uint32_t colours = in.get<std::uint32_t>();
    if (colours > 4 || !in.has(4.0 * colours)) return false;
    in.skip(4 * colours);
  }
  return true;
}

void OffReader::read_binary() {
  text_.next_line();
  if (header_.extras || header_.homogeneous) {
    source_.fail("binary OFF with colours or normals cannot be read; export it as text or PLY");
  }
  for (const bool colour_counts : {false, true}) {
    for (const std::endian order : {std::endian::big, std::endian::little}) {
      if (try_binary(order, colour_counts)) return finish("OFF (binary)");
    }
  }
  source_.fail_at_byte(static_cast<std::size_t>(text_.where() - source_.bytes().data()),
                       "the binary OFF does not match its counts; it is truncated or damaged, "
                       "export it again");
}

MeshFile OffReader::read() {
  header();
  if (header_.binary) {
    read_binary();
  } else {
    counts();
    vertices();
    faces();
    finish("OFF");
  }
  return std::move(file_);
}

}  // namespace

MeshFile read_off(const Source& source) { return OffReader(source).read(); }

}  // namespace burin
