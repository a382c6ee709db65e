#include "meshes.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <utility>

namespace burin::gltf {
namespace {

constexpr std::size_t kMostCorners = 300'000'000;  // primitives can name the same bytes many times
constexpr double kMm = 1000;

int attribute(const std::map<std::string, int>& attributes, const char* name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? -1 : found->second;
}

/// The corners of triangles, by their places in the list of indices.
class Corners {
 public:
  Corners(int mode, std::size_t indices)
      : mode_(mode),
        count_(indices < 3                       ? 0
               : mode == TINYGLTF_MODE_TRIANGLES ? indices / 3
                                                 : indices - 2) {}
  std::size_t count() const { return count_; }
  std::array<std::size_t, 3> of(std::size_t t) const {
    if (mode_ == TINYGLTF_MODE_TRIANGLES) return {3 * t, 3 * t + 1, 3 * t + 2};
    if (mode_ == TINYGLTF_MODE_TRIANGLE_FAN) return {t + 1, t + 2, 0};
    return {t, t + 1 + t % 2, t + 2 - t % 2};
  }

 private:
  int mode_;
  std::size_t count_;
};

bool is_triangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// One place in the soup a vertex that is used, in the order of their use.
class Taken {
 public:
  Taken(PolygonSoup& soup, const std::vector<Vec3>& points) : soup_(soup), points_(points) {}
  std::uint32_t place(std::uint32_t vertex) {
    const auto next = static_cast<std::uint32_t>(soup_.positions.size());
    const auto [known, is_new] = places_.try_emplace(vertex, next);
    if (is_new) soup_.positions.push_back(points_[vertex]);
    return known->second;
  }

 private:
  PolygonSoup& soup_;
  const std::vector<Vec3>& points_;
  std::unordered_map<std::uint32_t, std::uint32_t> places_;
};

}  // namespace

Vec3 in_mm(Vec3 metres) { return kMm * Vec3(metres.x, -metres.z, metres.y); }

Placement in_mm(const Placement& metres) {
  const auto turned = [](Vec3 v) { return Vec3(v.x, -v.z, v.y); };
  // Columns are where the axes go: ours are x, -z and y of the file.
  return {Mat3(turned(metres.linear[0]), turned(-metres.linear[2]), turned(metres.linear[1])),
          in_mm(metres.offset)};
}

bool Meshes::has_skin(const tinygltf::Node& node) const {
  return node.skin >= 0 && static_cast<std::size_t>(node.skin) < model_.skins.size() &&
         !model_.skins[static_cast<std::size_t>(node.skin)].joints.empty();
}

Meshes::Joints Meshes::joints_of(int skin, const Global& global) const {
  const tinygltf::Skin& of = model_.skins[static_cast<std::size_t>(skin)];
  Rows inverse;
  if (of.inverseBindMatrices >= 0) inverse = accessors_.read(of.inverseBindMatrices, 16);
  Joints joints;
  for (std::size_t j = 0; j < of.joints.size(); ++j) {
    Placement bind;
    if (j < inverse.count()) {
      for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r) {
          (c < 3 ? bind.linear[c] : bind.offset)[r] =
              inverse.at(j, static_cast<std::size_t>(4 * c + r));
        }
      }
    }
    joints.push_back(after(global(of.joints[j]), bind));
  }
  return joints;
}

/// Moves points by the joints that hold them, as strongly as they do.
void Meshes::pose(const tinygltf::Primitive& primitive, const Joints& joints,
                  std::vector<Vec3>& points) const {
  const std::vector<Vec3> rest = points;
  std::vector<double> total(points.size(), 0);
  std::vector<Vec3> moved(points.size(), Vec3(0));
  for (int set = 0;; ++set) {
    const int of_joints = attribute(primitive.attributes, fmt::format("JOINTS_{}", set).c_str());
    const int of_weights = attribute(primitive.attributes, fmt::format("WEIGHTS_{}", set).c_str());
    if (of_joints < 0 || of_weights < 0) break;
    const Rows which = accessors_.read(of_joints, 4), weight = accessors_.read(of_weights, 4);
    const std::size_t count = std::min({points.size(), which.count(), weight.count()});
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double w = weight.at(i, k), j = which.at(i, k);
        if (!(w > 0) || !(j >= 0 && j < static_cast<double>(joints.size()))) continue;
        moved[i] += w * joints[static_cast<std::size_t>(j)].point(rest[i]);
        total[i] += w;
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (total[i] > 0) points[i] = moved[i] / total[i];
  }
}

std::vector<Vec3> Meshes::positions(const tinygltf::Primitive& primitive, const Weights& weights,
                                    const Joints& joints) {
  const Rows rows = accessors_.read(attribute(primitive.attributes, "POSITION"), 3);
  std::vector<Vec3> points(rows.count());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = rows.point(i);
  for (std::size_t t = 0; t < primitive.targets.size() && t < weights.size(); ++t) {
    const int target = attribute(primitive.targets[t], "POSITION");
    if (weights[t] == 0 || target < 0) continue;
    const Rows moves = accessors_.read(target, 3);
    for (std::size_t i = 0; i < std::min(points.size(), moves.count()); ++i) {
      points[i] += weights[t] * moves.point(i);
    }
  }
  if (!joints.empty()) pose(primitive, joints, points);
  for (Vec3& p : points) p = in_mm(p);
  return points;
}

/// By vertices; empty where they have none.
std::vector<std::optional<LinearColor>> Meshes::vertex_colors(
    const tinygltf::Primitive& primitive) const {
  const int of_colors = attribute(primitive.attributes, "COLOR_0");
  if (of_colors < 0) return {};
  const Rows rows = accessors_.read(of_colors);
  if (rows.width < 3) return {};
  std::vector<std::optional<LinearColor>> out;
  out.reserve(rows.count());
  for (std::size_t i = 0; i < rows.count(); ++i) {
    out.push_back(LinearColor{rows.at(i, 0), rows.at(i, 1), rows.at(i, 2),
                              rows.width > 3 ? rows.at(i, 3) : 1});
  }
  return out;
}

/// The colours of triangles, given by the vertices of their corners: that of the material times
/// those of the vertices; without a material it is white.
void Meshes::add_looks(const tinygltf::Primitive& primitive,
                       std::span<const std::uint32_t> vertices, Shape& shape) const {
  const std::optional<LinearColor> material = color_of(model_, primitive.material);
  const auto shown = [](const std::optional<LinearColor>& color) {
    return color ? std::optional(displayed(*color)) : std::nullopt;
  };
  const std::vector<std::optional<LinearColor>> colors = vertex_colors(primitive);
  // Of a material that is a picture nothing is known.
  if (colors.empty() || (!material && primitive.material >= 0)) {
    return shape.look.add(shown(material), vertices.size() / 3);
  }
  const LinearColor base = material.value_or(LinearColor{1, 1, 1, 1});
  std::array<std::optional<Rgba>, 3> corners;
  for (std::size_t c = 0; c < vertices.size(); ++c) {
    std::optional<LinearColor> color;
    if (vertices[c] < colors.size()) color = colors[vertices[c]];
    for (std::size_t i = 0; color && i < 3; ++i) (*color)[i] *= base[i];
    if (color) (*color)[3] = base[3];
    corners[c % 3] = shown(color);
    if (c % 3 == 2) shape.look.add(color_of_corners(corners));
  }
}

void Meshes::add(const tinygltf::Primitive& primitive, const Weights& weights, const Joints& joints,
                 Shape& shape) {
  const int of_points = attribute(primitive.attributes, "POSITION");
  const bool plain = primitive.targets.empty() && joints.empty();
  if (!plain || of_points != points_of_) {
    points_ = positions(primitive, weights, joints);
    points_of_ = plain ? of_points : -1;
  }
  std::vector<std::uint32_t> indices;
  if (primitive.indices >= 0) indices = accessors_.indices(primitive.indices);
  const std::size_t listed = primitive.indices >= 0 ? indices.size() : points_.size();
  corners_ += listed;
  if (corners_ > kMostCorners) {
    source_.fail("asks for more than 100,000,000 triangles; it is damaged or hostile");
  }
  Rows uv;
  if (const int of_uv = attribute(primitive.attributes, "TEXCOORD_0"); of_uv >= 0) {
    uv = accessors_.read(of_uv, 2);
  }
  const Corners corners(primitive.mode, listed);
  std::vector<std::uint32_t> vertices;
  vertices.reserve(3 * corners.count());
  Taken taken(shape.soup, points_);
  for (std::size_t t = 0; t < corners.count(); ++t) {
    source_.context().check();
    for (const std::size_t c : corners.of(t)) {
      const auto v = indices.empty() ? static_cast<std::uint32_t>(c) : indices[c];
      if (v >= points_.size()) {
        source_.fail(
            fmt::format("a triangle of the glTF refers to vertex {}, its mesh has {}; it is "
                        "damaged, export it again",
                        v, points_.size()));
      }
      vertices.push_back(v);
      shape.soup.indices.push_back(taken.place(v));
      // The picture's v goes down.
      shape.soup.texture.push_back(v < uv.count()
                                       ? glm::vec2(uv.at(v, 0), 1 - uv.at(v, 1))
                                       : glm::vec2(std::numeric_limits<float>::quiet_NaN()));
    }
    shape.soup.offsets.push_back(shape.soup.indices.size());
  }
  add_looks(primitive, vertices, shape);
}

std::vector<MeshShape> Meshes::made(const tinygltf::Mesh& mesh, const Weights& weights,
                                    const Joints& joints) {
  std::map<int, Shape> shapes;  // by transparent material; -1: all that is opaque
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!is_triangles(primitive.mode)) {
      ++not_drawn_;
      continue;
    }
    const std::optional<LinearColor> color = color_of(model_, primitive.material);
    const bool opaque = !color || (*color)[3] == 1;
    Shape& shape = shapes[opaque ? -1 : primitive.material];
    if (!opaque) {
      shape.material = model_.materials[static_cast<std::size_t>(primitive.material)].name;
    }
    add(primitive, weights, joints, shape);
  }
  std::vector<MeshShape> out;
  for (auto& [key, shape] : shapes) {
    if (shape.soup.polygon_count() == 0) continue;
    many_colors_ += shape.look.too_many();
    colors_.push_back(shape.look.colors());
    out.push_back({objects_.size(), shapes.size() > 1 ? clean_name(shape.material) : std::string(),
                   shape.look.look()});
    shape.soup.name = clean_name(mesh.name);
    objects_.push_back(std::move(shape.soup));
  }
  return out;
}

const std::vector<MeshShape>& Meshes::of(const tinygltf::Node& node, const Global& global) {
  static const std::vector<MeshShape> none;
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) return none;
  const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
  const Weights& weights = node.weights.empty() ? mesh.weights : node.weights;
  const Joints joints = has_skin(node) ? joints_of(node.skin, global) : Joints();
  if (!joints.empty()) {
    skinned_ = made(mesh, weights, joints);
    return skinned_;
  }
  const auto known = made_.find({node.mesh, weights});
  if (known != made_.end()) return known->second;
  return made_.emplace(std::pair(node.mesh, weights), made(mesh, weights, joints)).first->second;
}

}  // namespace burin::gltf
