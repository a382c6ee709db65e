#include "byte_order_mark.h"
#include "formats.h"
#include "groups.h"
#include "obj_materials.h"
#include "text.h"
#include "texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>

// Own code: tinyobjloader and OpenMesh read floats, assimp has no line numbers in its errors.
namespace burin {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr float kNoColor = -1;
constexpr std::uint32_t kOutside = kNone - 1;  // refers to nothing that can be

class ObjReader {
 public:
  explicit ObjReader(const Source& source)
      : source_(source), text_(source, byte_order_mark(source.bytes())) {}
  MeshFile read();

 private:
  /// Whether it may go on in the next line.
  bool statement();
  void vertex();
  void vertex_color();
  void texture_point();
  void face();
  void corner();
  std::uint32_t texture_index(const char*& p) const;
  void begin(std::vector<std::string>& names, std::uint32_t& current);
  void material();
  bool name(std::string_view keyword);
  void other(std::string_view keyword, const char* where);
  void skip_blanks();
  /// Behind the present line, or, where it may go on in the next one, behind that one too.
  void next_line(bool continued);
  void finish_indices() const;
  std::vector<glm::vec2> finish_texture(Diagnostics& diagnostics) const;
  std::vector<std::optional<Rgba>> material_colors(Diagnostics& diagnostics) const;
  std::vector<std::optional<Rgba>> vertex_colors() const;
  void color(GroupedFaces& faces, Diagnostics& diagnostics) const;

  const Source& source_;
  TextCursor text_;
  std::vector<Vec3> positions_;
  /// Red, green and blue of those that have them, as they stand in the file; may be shorter.
  std::vector<glm::vec3> vertex_colors_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> offsets_{0};
  std::vector<glm::vec2> texture_points_;
  std::vector<std::uint32_t> corner_textures_;  // of each corner, or kNone
  std::vector<std::uint32_t> object_of_face_, group_of_face_, material_of_face_;
  /// In the order of the statements: one name several times may be several things.
  std::vector<std::string> objects_, groups_;
  std::unordered_map<std::string, std::uint32_t> materials_;
  std::vector<std::string> libraries_;
  std::uint32_t object_ = kNone, group_ = kNone, material_ = kNone;
  std::uint32_t largest_index_ = 0;
  const char* largest_index_at_ = nullptr;
  std::int64_t free_form_ = 0, unknown_ = 0, short_faces_ = 0, lines_ = 0, points_ = 0;
  const char* first_unknown_ = nullptr;
};

void ObjReader::skip_blanks() {
  for (;;) {
    text_.skip_blanks();
    if (text_.peek() != '\\' || text_.left() < 2 || !is_line_end(text_.where()[1])) return;
    text_.next_line();  // a continued line
  }
}

void ObjReader::next_line(bool continued) {
  if (!continued) return text_.next_line();
  while (continued) {
    while (!text_.at_line_end()) text_.skip(1);
    continued =
        text_.where() > source_.bytes().data() && text_.where()[-1] == '\\' && !text_.at_end();
    text_.next_line();
  }
}

void ObjReader::vertex() {
  Vec3 p;
  for (int i = 0; i < 3; ++i) {
    skip_blanks();
    p[i] = text_.number("a coordinate");
  }
  if (positions_.size() == kNone) text_.fail("more than 4,294,967,294 vertices; split the model");
  positions_.push_back(p);
  vertex_color();
}

/// Many programs write red, green and blue behind the coordinates; a number alone is a weight.
void ObjReader::vertex_color() {
  glm::vec3 color(kNoColor);
  for (int i = 0; i < 3; ++i) {
    skip_blanks();
    double value = 0;
    if (text_.at_line_end() || text_.peek() == '#' || !parse_double(text_.token(), value)) return;
    color[i] = static_cast<float>(value);
  }
  vertex_colors_.resize(positions_.size(), glm::vec3(kNoColor));
  vertex_colors_.back() = color;
}

void ObjReader::texture_point() {
  glm::vec2 uv(kNoTexture, 0);  // the second is 0 where the texture is a line
  for (int i = 0; i < 2; ++i) {
    skip_blanks();
    if (text_.at_line_end() || text_.peek() == '#') break;
    uv[i] = texture_coordinate(text_.token());
  }
  texture_points_.push_back(uv);
}

// The index after the first slash of a corner, at which `p` is; what is none is kNone. Texture is
// not worth refusing a model.
std::uint32_t ObjReader::texture_index(const char*& p) const {
  const char* end = text_.where() + text_.left();
  if (p == end || *p != '/') return kNone;
  std::int64_t value = 0;
  const char* digits = ++p;
  const auto [stop, error] = std::from_chars(digits, end, value);
  p = stop;
  if (error != std::errc() || value == 0) return kNone;
  const auto count = static_cast<std::int64_t>(texture_points_.size());
  if (value < 0) value = count + 1 + value;
  return value < 1 || value >= kNone ? kOutside : static_cast<std::uint32_t>(value - 1);
}

void ObjReader::corner() {
  const char* begin = text_.where();
  const char* p = begin;
  const bool negative = *p == '-';
  if (negative || *p == '+') ++p;
  std::int64_t value = 0;
  const char* digits = p;
  while (is_digit(*p) && p - digits < 12) value = 10 * value + (*p++ - '0');
  const bool ends = *p == '/' || *p == '\\' || *p == '#' || is_blank(*p) || is_line_end(*p) ||
                    p == begin + text_.left();
  if (p == digits || !ends)
    text_.fail(in_quotes(text_.token()) + " is not a corner of a face; export it again");
  if (negative) value = static_cast<std::int64_t>(positions_.size()) + 1 - value;
  if (value < 1 || value >= kNone) {
    text_.fail(fmt::format(
        "the face refers to vertex {}, but vertices are numbered from 1 and {} come "
        "before this line; export it again",
        std::string_view(begin, static_cast<std::size_t>(p - begin)), positions_.size()));
  }
  // A vertex may come after the face, so the upper bound is checked at the end of the file.
  if (value > largest_index_) {
    largest_index_ = static_cast<std::uint32_t>(value);
    largest_index_at_ = begin;
  }
  corners_.push_back(static_cast<std::uint32_t>(value - 1));
  const bool more = *p == '/';
  corner_textures_.push_back(texture_index(p));
  // The normal is not used.
  while (more && *p != '\\' && *p != '#' && !is_blank(*p) && !is_line_end(*p) &&
         p != begin + text_.left())
    ++p;
  text_.skip(static_cast<std::size_t>(p - begin));
}

void ObjReader::face() {
  const std::size_t begin = corners_.size();
  for (skip_blanks(); !text_.at_line_end() && text_.peek() != '#'; skip_blanks()) corner();
  if (corners_.size() - begin < 3) {
    corners_.resize(begin);
    corner_textures_.resize(begin);
    ++short_faces_;
    return;
  }
  offsets_.push_back(corners_.size());
  object_of_face_.push_back(object_);
  group_of_face_.push_back(group_);
  material_of_face_.push_back(material_);
}

/// The object or group of the faces that follow.
void ObjReader::begin(std::vector<std::string>& names, std::uint32_t& current) {
  const std::string_view name = text_.rest_of_line();
  current = static_cast<std::uint32_t>(names.size());
  names.emplace_back(name);
}

void ObjReader::material() {
  const std::string name(text_.rest_of_line());
  material_ =
      materials_.try_emplace(name, static_cast<std::uint32_t>(materials_.size())).first->second;
}

void ObjReader::other(std::string_view keyword, const char* where) {
  static constexpr std::string_view kHarmless[] = {
      "vn",    "vp",       "s",        "usemap",     "maplib",    "mg", "lod",
      "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "vc"};
  static constexpr std::string_view kFreeForm[] = {
      "curv", "curv2", "surf", "cstype", "deg", "bmat", "step",  "parm",
      "trim", "hole",  "scrv", "sp",     "end", "con",  "ctech", "stech"};
  if (keyword == "l" || keyword == "p") {
    ++(keyword == "l" ? lines_ : points_);
    return;
  }
  if (std::ranges::find(kHarmless, keyword) != std::end(kHarmless)) return;
  if (std::ranges::find(kFreeForm, keyword) != std::end(kFreeForm)) {
    free_form_ += keyword == "surf";
    return;
  }
  if (unknown_++ == 0) first_unknown_ = where;
}

/// A name takes its line whole: the second byte of a letter of Shift-JIS may be a backslash, and
/// folders end in one.
bool ObjReader::name(std::string_view keyword) {
  if (keyword == "o") {
    begin(objects_, object_);
  } else if (keyword == "g") {
    begin(groups_, group_);
  } else if (keyword == "usemtl") {
    material();
  } else if (keyword == "mtllib") {
    libraries_.emplace_back(text_.rest_of_line());
  } else {
    return false;
  }
  return true;
}

bool ObjReader::statement() {
  const char* where = text_.where();
  const std::string_view keyword = text_.token();
  if (name(keyword)) return false;
  if (keyword == "v") {
    vertex();
  } else if (keyword == "vt") {
    texture_point();
  } else if (keyword == "f" || keyword == "fo") {
    face();
  } else {
    other(keyword, where);
  }
  return true;
}

void ObjReader::finish_indices() const {
  if (largest_index_ > positions_.size()) {
    source_.fail_at_line(
        largest_index_at_,
        fmt::format("the face refers to vertex {}, the file holds {}; it is truncated "
                    "or damaged, export it again",
                    largest_index_, positions_.size()));
  }
}

std::vector<glm::vec2> ObjReader::finish_texture(Diagnostics& diagnostics) const {
  if (texture_points_.empty()) return {};
  std::vector<glm::vec2> texture;
  texture.reserve(corner_textures_.size());
  std::int64_t beyond = 0;
  for (const std::uint32_t i : corner_textures_) {
    const bool found = i < texture_points_.size();
    beyond += !found && i != kNone;
    texture.push_back(found ? texture_points_[i] : glm::vec2(kNoTexture));
  }
  if (beyond > 0) {
    diagnostics.add(Severity::Warning, "obj.bad_texture", beyond,
                    fmt::format("corners refer to texture coordinates that the file does not hold "
                                "(it has {}); they are drawn without",
                                texture_points_.size()));
  }
  return texture;
}

/// By materials, in the order of their numbers; empty where none has one.
std::vector<std::optional<Rgba>> ObjReader::material_colors(Diagnostics& diagnostics) const {
  if (materials_.empty()) return {};
  const ObjMaterials known = read_obj_materials(libraries_, source_, diagnostics);
  std::vector<std::optional<Rgba>> of_material(materials_.size());
  for (const auto& [name, index] : materials_) {
    const auto found = known.find(name);
    if (found != known.end()) of_material[index] = found->second;
  }
  if (std::ranges::none_of(of_material, [](const auto& c) { return c.has_value(); })) return {};
  return of_material;
}

/// By vertices; empty where none has one.
std::vector<std::optional<Rgba>> ObjReader::vertex_colors() const {
  if (vertex_colors_.empty()) return {};
  // Shares of 1, or of 255 where they are far over 1.
  constexpr float kMostOfOne = 1.5F;
  float most = 0;
  for (const glm::vec3& c : vertex_colors_) most = std::max({most, c.x, c.y, c.z});
  const double full = most > kMostOfOne ? 255 : 1;
  std::vector<std::optional<Rgba>> colors(positions_.size());
  for (std::size_t v = 0; v < vertex_colors_.size(); ++v) {
    const glm::vec3& c = vertex_colors_[v];
    if (c.x >= 0)
      colors[v] = Rgba{channel(c.x / full), channel(c.y / full), channel(c.z / full), 255};
  }
  return colors;
}

/// The colour of its material, else that of most of its corners.
void ObjReader::color(GroupedFaces& faces, Diagnostics& diagnostics) const {
  const auto of_material = material_colors(diagnostics), of_vertex = vertex_colors();
  if (of_material.empty() && of_vertex.empty()) return;
  faces.color.reserve(material_of_face_.size());
  std::vector<std::optional<Rgba>> of_corner;
  for (std::size_t f = 0; f < material_of_face_.size(); ++f) {
    const std::uint32_t m = material_of_face_[f];
    std::optional<Rgba>& color = faces.color.emplace_back();
    if (m != kNone && !of_material.empty()) color = of_material[m];
    if (color || of_vertex.empty()) continue;
    const auto corners = std::span(corners_).subspan(offsets_[f], offsets_[f + 1] - offsets_[f]);
    of_corner.clear();
    for (const std::uint32_t v : corners) of_corner.push_back(of_vertex[v]);
    color = color_of_corners(of_corner);
  }
}

MeshFile ObjReader::read() {
  for (text_.skip_space(); !text_.at_end(); text_.skip_space()) {
    source_.context().check();
    if (text_.peek() == '#') {
      text_.next_line();
    } else {
      next_line(statement());
    }
  }
  finish_indices();
  if (offsets_.size() == 1) {
    if (first_unknown_ != nullptr)
      source_.fail_at_line(
          first_unknown_, "is no OBJ statement, and the file holds no face; is it another format?");
    source_.fail(
        fmt::format("holds {} vertices but no face; export it as a surface", positions_.size()));
  }

  MeshFile file;
  file.format = "OBJ";
  if (short_faces_ > 0) {
    file.diagnostics.add(Severity::Warning, "obj.short_faces", short_faces_,
                         "faces of fewer than three corners were left out");
  }
  if (lines_ + points_ > 0) {
    // Lines may be what somebody drew.
    file.diagnostics.add(lines_ > 0 ? Severity::Warning : Severity::Info, "obj.no_faces",
                         lines_ + points_,
                         "lines and points of the OBJ, which have no faces, were left out");
  }
  if (free_form_ > 0) {
    file.diagnostics.add(Severity::Warning, "obj.free_form", free_form_,
                         "free-form surfaces were left out; only polygons are read");
  }
  if (unknown_ > 0) {
    file.diagnostics.add(Severity::Info, "obj.unknown_statements", unknown_,
                         fmt::format("unknown statements were ignored, the first on line {}",
                                     source_.line_of(first_unknown_)));
  }
  const bool by_object = !objects_.empty();
  GroupedFaces faces;
  color(faces, file.diagnostics);
  faces.positions = std::move(positions_);
  faces.indices = std::move(corners_);
  faces.offsets = std::move(offsets_);
  faces.texture = finish_texture(file.diagnostics);
  faces.group = by_object ? std::move(object_of_face_) : std::move(group_of_face_);
  faces.names = by_object ? std::move(objects_) : std::move(groups_);
  using Join = GroupedFaces::Join;
  faces.join = by_object ? Join::OneName : Join::Connected;
  split_groups(std::move(faces), file, source_.context());
  return file;
}

}  // namespace

MeshFile read_obj(const Source& source) { return ObjReader(source).read(); }

}  // namespace burin
