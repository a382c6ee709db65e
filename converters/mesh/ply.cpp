#include "binary.h"
#include "formats.h"
#include "groups.h"
#include "ply_color.h"
#include "ply_header.h"
#include "text.h"
#include "texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

// Own code: OpenMesh reads floats only, CGAL gives no byte of an error, and neither checks the
// counts before it allocates.
namespace burin {
namespace {

std::string too_many(const PlyElement& e) {
  return fmt::format(
      "the PLY claims {} elements '{}', more than the bytes that follow hold; it is "
      "truncated or damaged, export it again",
      e.count, e.name);
}

constexpr int kAxisU = 3;

/// Of a property of vertices: 0 to 2 for x, y, z; kAxisU and the next for u and v; else -1.
int axis(std::string_view name) {
  static constexpr std::array<std::array<std::string_view, 2>, 5> kTexture{
      {{"s", "t"},
       {"u", "v"},
       {"texture_u", "texture_v"},
       {"texture_s", "texture_t"},
       {"texcoord_u", "texcoord_v"}}};
  if (name.size() == 1 && name[0] >= 'x' && name[0] <= 'z') return name[0] - 'x';
  for (const auto& [u, v] : kTexture) {
    if (name == u) return kAxisU;
    if (name == v) return kAxisU + 1;
  }
  return -1;
}

bool is_texture_list(const PlyProperty& p) { return p.is_list && p.name == "texcoord"; }

/// Whether each of an element has one u and one v.
bool has_uv(const PlyElement& e) {
  const auto count = [&](int wanted) {
    return std::ranges::count_if(
        e.properties, [&](const PlyProperty& p) { return !p.is_list && axis(p.name) == wanted; });
  };
  return count(kAxisU) == 1 && count(kAxisU + 1) == 1;
}

bool has_texture(const PlyElement& e) {
  return has_uv(e) || std::ranges::any_of(e.properties, is_texture_list);
}

/// The numbers of a text, one after the other.
class AsciiValues {
 public:
  AsciiValues(const Source& source, std::size_t offset) : text_(source, offset) {}
  double value(PlyType) {
    text_.skip_space();
    return text_.number("a number");
  }
  std::size_t list_length(PlyType, PlyType) {
    text_.skip_space();
    return text_.count("the length of a list", 1);
  }
  void require(const PlyElement& e) {
    // A digit and a blank a property, the last blank missing.
    const double each = 2.0 * static_cast<double>(e.properties.size());
    if (static_cast<double>(e.count) * each > static_cast<double>(text_.left()) + 1) {
      text_.fail(too_many(e));
    }
  }
  [[noreturn]] void fail(const std::string& what) const { text_.fail(what); }

 private:
  TextCursor text_;
};

double load_as_double(const char* p, PlyType type, std::endian order) {
  switch (type) {
    case PlyType::Int8:
      return load<std::int8_t>(p, order);
    case PlyType::UInt8:
      return load<std::uint8_t>(p, order);
    case PlyType::Int16:
      return load<std::int16_t>(p, order);
    case PlyType::UInt16:
      return load<std::uint16_t>(p, order);
    case PlyType::Int32:
      return load<std::int32_t>(p, order);
    case PlyType::UInt32:
      return load<std::uint32_t>(p, order);
    case PlyType::Float:
      return load<float>(p, order);
    case PlyType::Double:
      return load<double>(p, order);
  }
  return 0;
}

/// The numbers of binary data.
class BinaryValues {
 public:
  BinaryValues(const Source& source, std::size_t offset, std::endian order)
      : source_(source), in_(source, offset, order), order_(order) {}
  double value(PlyType type) {
    const std::size_t size = size_of(type);
    if (!in_.has(static_cast<double>(size))) truncated();
    const double v = load_as_double(in_.data(), type, order_);
    in_.skip(size);
    return v;
  }
  std::size_t list_length(PlyType count_type, PlyType type) {
    const std::size_t begin = in_.offset();
    const double n = value(count_type);
    if (n < 0 || !in_.has(n * static_cast<double>(size_of(type)))) {
      source_.fail_at_byte(begin,
                           fmt::format("a list of {} numbers does not fit into the bytes that "
                                       "follow; the PLY is truncated or damaged, export it again",
                                       n));
    }
    return static_cast<std::size_t>(n);
  }
  void require(const PlyElement& e) {
    const double bytes = static_cast<double>(e.count) * static_cast<double>(e.least_bytes());
    if (!in_.has(bytes)) fail(too_many(e));
  }
  [[noreturn]] void fail(const std::string& what) const {
    source_.fail_at_byte(in_.offset(), what);
  }

 private:
  [[noreturn]] void truncated() const {
    fail("the PLY ends inside an element; it is truncated, export it again");
  }
  const Source& source_;
  BinaryCursor in_;
  std::endian order_;
};

template <class Values>
class PlyReader {
 public:
  PlyReader(const Source& source, const PlyHeader& header, Values values)
      : source_(source),
        header_(header),
        values_(values),
        textured_(std::ranges::any_of(header.elements, has_texture)) {}
  MeshFile read();

 private:
  void vertices(const PlyElement& e);
  void faces(const PlyElement& e, bool strips);
  void skip(const PlyProperty& p);
  void index_list(const PlyProperty& p);
  void texture_list(const PlyProperty& p);
  void take_corner(std::int64_t vertex, std::size_t place);
  void end_face();
  void end_strip();

  const Source& source_;
  const PlyHeader& header_;
  Values values_;
  PolygonSoup soup_;
  std::size_t vertex_count_ = 0;
  std::vector<std::int64_t> list_;
  // u and v of each vertex; of the corners of the face at hand, where the file has a list of them.
  std::vector<glm::vec2> vertex_texture_, face_texture_;
  std::vector<std::optional<Rgba>> vertex_colors_;
  FaceLooks face_looks_;
  std::int64_t short_faces_ = 0, edges_ = 0;
  const bool textured_;  // some element tells u and v
};

template <class Values>
void PlyReader<Values>::skip(const PlyProperty& p) {
  const std::size_t n = p.is_list ? values_.list_length(p.count_type, p.type) : 1;
  for (std::size_t i = 0; i < n; ++i) values_.value(p.type);
}

template <class Values>
void PlyReader<Values>::vertices(const PlyElement& e) {
  // For each property the axis it is the coordinate of, 3 and 4 those of the texture, or -1.
  std::vector<int> axis_of;
  for (const PlyProperty& p : e.properties) axis_of.push_back(p.is_list ? -1 : axis(p.name));
  for (const int k : {0, 1, 2}) {
    if (std::ranges::count(axis_of, k) != 1) {
      values_.fail("the vertices of the PLY have no coordinates x, y and z; export it again");
    }
  }
  if (e.count >= std::numeric_limits<std::uint32_t>::max()) {
    values_.fail("more than 4,294,967,294 vertices; split the model");
  }
  soup_.positions.reserve(e.count);
  const bool textured = has_uv(e);
  PlyColors colors(e);
  for (std::size_t i = 0; i < e.count; ++i) {
    source_.context().check();
    Vec3 position;
    glm::vec2 uv(0);
    for (std::size_t k = 0; k < axis_of.size(); ++k) {
      if (axis_of[k] < 0) {
        if (colors.takes(k)) {
          colors.take(k, values_.value(e.properties[k].type));
        } else {
          skip(e.properties[k]);
        }
        continue;
      }
      const double value = values_.value(e.properties[k].type);
      if (axis_of[k] < kAxisU) {
        position[axis_of[k]] = value;
      } else {
        uv[axis_of[k] - kAxisU] = static_cast<float>(value);
      }
    }
    soup_.positions.push_back(position);
    if (textured) vertex_texture_.push_back(uv);
    if (colors.any()) vertex_colors_.emplace_back(colors.color());
  }
}

template <class Values>
void PlyReader<Values>::index_list(const PlyProperty& p) {
  const std::size_t n = values_.list_length(p.count_type, p.type);
  for (std::size_t i = 0; i < n; ++i) {
    const double v = values_.value(p.type);
    const bool restart = v == -1;  // of a strip
    if (!restart && !(v >= 0 && v < static_cast<double>(vertex_count_) && v == std::floor(v))) {
      values_.fail(
          fmt::format("a face refers to vertex {}, the file holds 0 to {}; it is damaged, export "
                      "it again",
                      v, static_cast<std::int64_t>(vertex_count_) - 1));
    }
    list_.push_back(static_cast<std::int64_t>(v));
  }
}

// u and v of the corners of a face, in turn.
template <class Values>
void PlyReader<Values>::texture_list(const PlyProperty& p) {
  const std::size_t n = values_.list_length(p.count_type, p.type);
  face_texture_.assign((n + 1) / 2, glm::vec2(kNoTexture));
  for (std::size_t i = 0; i < n; ++i) {
    face_texture_[i / 2][static_cast<glm::length_t>(i % 2)] =
        static_cast<float>(values_.value(p.type));
  }
}

template <class Values>
void PlyReader<Values>::take_corner(std::int64_t vertex, std::size_t place) {
  soup_.indices.push_back(static_cast<std::uint32_t>(vertex));
  if (!textured_) return;
  glm::vec2 uv(kNoTexture);
  if (face_texture_.size() == list_.size()) {
    uv = face_texture_[place];
  } else if (!vertex_texture_.empty()) {
    uv = vertex_texture_[static_cast<std::size_t>(vertex)];
  }
  soup_.texture.push_back(uv);
}

template <class Values>
void PlyReader<Values>::end_face() {
  if (std::ranges::find(list_, -1) != list_.end()) {
    values_.fail("a face refers to vertex -1; the file is damaged, export it again");
  }
  if (list_.size() < 3) {
    ++short_faces_;
    return;
  }
  for (std::size_t i = 0; i < list_.size(); ++i) take_corner(list_[i], i);
  soup_.offsets.push_back(soup_.indices.size());
}

/// Triangles of a strip: every second one turns the other way, and -1 begins the next strip.
template <class Values>
void PlyReader<Values>::end_strip() {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (list_[i] < 0) begin = i + 1;
    if (i < begin + 2) continue;
    const bool odd = (i - begin) % 2 == 1;
    const std::size_t a = i - 2, b = i - 1;
    for (const std::size_t k : {odd ? b : a, odd ? a : b, i}) {
      take_corner(list_[k], k);
    }
    soup_.offsets.push_back(soup_.indices.size());
  }
}

template <class Values>
void PlyReader<Values>::faces(const PlyElement& e, bool strips) {
  const auto texture = std::ranges::find_if(e.properties, is_texture_list);
  const auto indices = std::ranges::find_if(e.properties, [](const PlyProperty& p) {
    return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
  });
  if (indices == e.properties.end()) {
    values_.fail(fmt::format(
        "the elements '{}' of the PLY have no list vertex_indices; export it again", e.name));
  }
  PlyColors colors(e);
  for (std::size_t i = 0; i < e.count; ++i) {
    source_.context().check();
    list_.clear();
    face_texture_.clear();
    for (std::size_t k = 0; k < e.properties.size(); ++k) {
      const PlyProperty& p = e.properties[k];
      if (&p == &*indices) {
        index_list(p);
      } else if (texture != e.properties.end() && &p == &*texture) {
        texture_list(p);
      } else if (colors.takes(k)) {
        colors.take(k, values_.value(p.type));
      } else {
        skip(p);
      }
    }
    const std::size_t before = soup_.polygon_count();
    strips ? end_strip() : end_face();
    if (colors.any()) face_looks_.add(colors.color(), soup_.polygon_count() - before);
  }
}

template <class Values>
MeshFile PlyReader<Values>::read() {
  for (const PlyElement& e : header_.elements) {
    if (e.name == "vertex") vertex_count_ = e.count;
  }
  for (const PlyElement& e : header_.elements) {
    if (e.properties.empty()) continue;
    values_.require(e);
    if (e.name == "vertex" && soup_.positions.empty()) {
      vertices(e);
    } else if (e.name == "face" && e.count > 0) {
      faces(e, false);
    } else if (e.name == "tristrips" && e.count > 0) {
      faces(e, true);
    } else {
      if (e.name == "edge") edges_ += static_cast<std::int64_t>(e.count);
      for (std::size_t i = 0; i < e.count; ++i) {
        source_.context().check();
        for (const PlyProperty& p : e.properties) skip(p);
      }
    }
  }
  if (soup_.polygon_count() == 0) {
    source_.fail(
        fmt::format("holds {} vertices but no face of three corners; a point cloud must be made "
                    "into a surface first",
                    vertex_count_));
  }
  MeshFile file;
  file.format = header_.ascii ? "PLY (ASCII)" : "PLY (binary)";
  if (short_faces_ > 0) {
    file.diagnostics.add(Severity::Warning, "ply.short_faces", short_faces_,
                         "faces of fewer than three corners were left out");
  }
  if (edges_ > 0) {
    file.diagnostics.add(Severity::Warning, "ply.no_faces", edges_,
                         "edges of the PLY, which have no faces, were left out");
  }
  add_use(face_looks_.any() ? face_looks_ : looks_by_vertices(soup_, vertex_colors_), file);
  file.objects.push_back(std::move(soup_));
  return file;
}

}  // namespace

MeshFile read_ply(const Source& source) {
  const PlyHeader header = read_ply_header(source);
  if (header.ascii) return PlyReader(source, header, AsciiValues(source, header.data)).read();
  return PlyReader(source, header, BinaryValues(source, header.data, header.order)).read();
}

}  // namespace burin
