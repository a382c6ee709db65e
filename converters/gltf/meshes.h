#pragma once
// Meshes of a glTF as polygons in mm, z up; internal to the module.

#include <burin/base/placement.h>
#include <burin/mesh/tri_mesh.h>

#include "accessors.h"
#include "look.h"
#include "materials.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace burin::gltf {

/// All of a mesh, or what of it has one transparent material.
struct MeshShape {
  std::size_t object = 0;
  /// Of the material, where a mesh has several shapes; else empty.
  std::string material;
  Appearance look;
};

/// From metres with y up to mm with z up.
Vec3 in_mm(Vec3 metres);
Placement in_mm(const Placement& metres);

class Meshes {
 public:
  /// `global`: where a node stands.
  using Global = std::function<Placement(int node)>;

  Meshes(const tinygltf::Model& model, const Source& source)
      : model_(model), source_(source), accessors_(model, source) {}

  /// The mesh of a node, with the morph targets as strong as the node has them. With a skin as its
  /// joints stand: in the scene rather than in the node.
  const std::vector<MeshShape>& of(const tinygltf::Node& node, const Global& global);

  /// Whether joints that are there hold the mesh of a node.
  bool has_skin(const tinygltf::Node& node) const;

  std::vector<PolygonSoup> take() { return std::move(objects_); }
  /// As those of MeshFile.
  std::vector<std::shared_ptr<const FaceColors>> take_colors() { return std::move(colors_); }
  /// Primitives that are no triangles, and shapes of too many colours.
  std::int64_t not_drawn() const { return not_drawn_; }
  std::int64_t many_colors() const { return many_colors_; }
  const Accessors& accessors() const { return accessors_; }

 private:
  struct Shape {
    PolygonSoup soup;
    FaceLooks look;
    std::string material;
  };
  using Weights = std::vector<double>;
  /// Where the joints of a skin put what is bound to them.
  using Joints = std::vector<Placement>;

  Joints joints_of(int skin, const Global& global) const;
  std::vector<Vec3> positions(const tinygltf::Primitive& primitive, const Weights& weights,
                              const Joints& joints);
  void pose(const tinygltf::Primitive& primitive, const Joints& joints,
            std::vector<Vec3>& points) const;
  std::vector<std::optional<LinearColor>> vertex_colors(const tinygltf::Primitive& primitive) const;
  void add_looks(const tinygltf::Primitive& primitive, std::span<const std::uint32_t> vertices,
                 Shape& shape) const;
  void add(const tinygltf::Primitive& primitive, const Weights& weights, const Joints& joints,
           Shape& shape);
  std::vector<MeshShape> made(const tinygltf::Mesh& mesh, const Weights& weights,
                              const Joints& joints);

  const tinygltf::Model& model_;
  const Source& source_;
  Accessors accessors_;
  std::vector<PolygonSoup> objects_;
  std::vector<std::shared_ptr<const FaceColors>> colors_;
  /// By mesh and weights; those with skins are made for their nodes alone.
  std::map<std::pair<int, Weights>, std::vector<MeshShape>> made_;
  std::vector<MeshShape> skinned_;
  /// Positions that were read last: primitives often share them.
  int points_of_ = -1;
  std::vector<Vec3> points_;
  std::size_t corners_ = 0;
  std::int64_t not_drawn_ = 0, many_colors_ = 0;
};

}  // namespace burin::gltf
