#include "nodes.h"

#include <burin/assembly/items.h>

#include "meshes.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace burin::gltf {
namespace {

constexpr std::size_t kMostUses = 1'000'000;

double at(const std::vector<double>& values, std::size_t i, double absent) {
  return i < values.size() ? values[i] : absent;
}

/// The turn of a quaternion x, y, z, w of any length over 0.
Mat3 turn(double x, double y, double z, double w) {
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  if (!(length > 0)) return Mat3(1);
  x /= length, y /= length, z /= length, w /= length;
  return {1 - 2 * (y * y + z * z), 2 * (x * y + z * w),     2 * (x * z - y * w),
          2 * (x * y - z * w),     1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
          2 * (x * z + y * w),     2 * (y * z - x * w),     1 - 2 * (x * x + y * y)};
}

Placement place_of(const std::vector<double>& translation, const std::vector<double>& rotation,
                   const std::vector<double>& scale) {
  Placement place;
  place.linear = turn(at(rotation, 0, 0), at(rotation, 1, 0), at(rotation, 2, 0),
                      at(rotation, 3, rotation.empty() ? 1 : 0));
  for (int i = 0; i < 3; ++i) {
    place.linear[i] *= at(scale, static_cast<std::size_t>(i), 1);
    place.offset[i] = at(translation, static_cast<std::size_t>(i), 0);
  }
  return place;
}

Placement place_of(const tinygltf::Node& node) {
  if (node.matrix.size() != 16) return place_of(node.translation, node.rotation, node.scale);
  Placement place;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) {
      (c < 3 ? place.linear[c] : place.offset)[r] =
          node.matrix[static_cast<std::size_t>(4 * c + r)];
    }
  }
  return place;
}

bool is_visible(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_node_visibility");
  if (found == node.extensions.end() || !found->second.IsObject()) return true;
  const tinygltf::Value& visible = found->second.Get("visible");
  return !visible.IsBool() || visible.Get<bool>();
}

/// A node of the scene, with what is above it.
struct Visit {
  int node = 0;
  Placement place = {};
  std::vector<std::string> above = {};
};

class Nodes {
 public:
  Nodes(const tinygltf::Model& model, const Source& source)
      : model_(model),
        source_(source),
        meshes_(model, source),
        place_(model.nodes.size()),
        seen_(model.nodes.size(), false) {}

  MeshFile read() {
    file_.format = source_.bytes().starts_with("glTF") ? "glTF (binary)" : "glTF";
    walk();
    count_users();
    for (const Visit& visit : visits_) emit(visit);
    report();
    file_.polygon_colors = meshes_.take_colors();
    file_.objects = meshes_.take();
    if (file_.uses.empty()) {
      if (missing_ > 0)
        source_.fail("a node of the glTF's scene is not there; it is damaged, export it again");
      source_.fail("the glTF has no triangles; export the model as meshes");
    }
    return std::move(file_);
  }

 private:
  std::vector<int> roots() const;
  void walk();
  void count_users();
  std::vector<Placement> instances(const tinygltf::Node& node) const;
  std::string name_of(const Visit& visit) const;
  std::string definition_of(const tinygltf::Node& node) const;
  void emit(const Visit& visit);
  void report();

  const tinygltf::Model& model_;
  const Source& source_;
  Meshes meshes_;
  std::vector<Visit> visits_;
  std::vector<Placement> place_;
  std::vector<bool> seen_;
  /// How many nodes show a mesh, and what their names have in common; nothing where they differ.
  struct Users {
    std::size_t count = 0;
    std::optional<std::string> stem;
  };
  std::map<int, Users> users_;
  std::int64_t hidden_ = 0, missing_ = 0;
  MeshFile file_;
};

/// Of the scene that is shown; without scenes all nodes that have none above them.
std::vector<int> Nodes::roots() const {
  if (!model_.scenes.empty()) {
    const auto shown = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
    return model_.scenes[std::min(shown, model_.scenes.size() - 1)].nodes;
  }
  std::vector<bool> below(model_.nodes.size(), false);
  for (const tinygltf::Node& node : model_.nodes) {
    for (const int child : node.children) {
      if (child >= 0 && static_cast<std::size_t>(child) < below.size()) {
        below[static_cast<std::size_t>(child)] = true;
      }
    }
  }
  std::vector<int> out;
  for (std::size_t i = 0; i < below.size(); ++i) {
    if (!below[i]) out.push_back(static_cast<int>(i));
  }
  return out;
}

void Nodes::walk() {
  std::vector<Visit> open;
  const auto push = [&](const std::vector<int>& nodes, const Visit& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      open.push_back({*node, parent.place, parent.above});
    }
  };
  push(roots(), {});
  while (!open.empty()) {
    source_.context().check();
    Visit visit = std::move(open.back());
    open.pop_back();
    const auto index = static_cast<std::size_t>(visit.node);
    if (visit.node < 0 || index >= model_.nodes.size()) {
      ++missing_;
      continue;
    }
    if (seen_[index]) {
      source_.fail(fmt::format(
          "the glTF's node {} is in two places; it is damaged, export it again", visit.node));
    }
    seen_[index] = true;
    const tinygltf::Node& node = model_.nodes[index];
    visit.place = after(visit.place, place_of(node));
    place_[index] = visit.place;
    if (!is_visible(node)) {
      ++hidden_;
      continue;
    }
    Visit below = visit;
    if (std::string name = clean_name(node.name); !name.empty() && !node.children.empty()) {
      below.above.push_back(std::move(name));
    }
    push(node.children, below);
    visits_.push_back(std::move(visit));
  }
}

void Nodes::count_users() {
  for (const Visit& visit : visits_) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(visit.node)];
    if (node.mesh < 0) continue;
    Users& users = users_[node.mesh];
    const std::string stem = instance_stem(clean_name(node.name));
    if (users.count++ == 0) {
      users.stem = stem;
    } else if (users.stem != stem) {
      users.stem.reset();
    }
  }
}

/// Where EXT_mesh_gpu_instancing puts the mesh of a node, again and again; else once.
std::vector<Placement> Nodes::instances(const tinygltf::Node& node) const {
  const auto found = node.extensions.find("EXT_mesh_gpu_instancing");
  if (found == node.extensions.end() || !found->second.IsObject()) return {Placement{}};
  const tinygltf::Value& attributes = found->second.Get("attributes");
  const auto rows = [&](const char* name, std::size_t width) {
    if (!attributes.IsObject() || !attributes.Has(name)) return Rows{};
    const tinygltf::Value& accessor = attributes.Get(name);
    return accessor.IsInt() ? meshes_.accessors().read(accessor.Get<int>(), width) : Rows{};
  };
  const Rows moves = rows("TRANSLATION", 3), turns = rows("ROTATION", 4), scales = rows("SCALE", 3);
  const auto row = [](const Rows& of, std::size_t i) {
    if (i >= of.count()) return std::vector<double>();
    const auto begin = of.values.begin() + static_cast<std::ptrdiff_t>(i * of.width);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(of.width));
  };
  std::vector<Placement> out;
  const std::size_t count = std::max({moves.count(), turns.count(), scales.count()});
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(place_of(row(moves, i), row(turns, i), row(scales, i)));
  }
  return out;
}

/// That of the node, else of its mesh, else of what is above it.
std::string Nodes::name_of(const Visit& visit) const {
  const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(visit.node)];
  std::string name = clean_name(node.name);
  if (name.empty()) name = clean_name(model_.meshes[static_cast<std::size_t>(node.mesh)].name);
  if (name.empty() && !visit.above.empty()) name = visit.above.back();
  return name;
}

/// What several nodes of one mesh are instances of: the mesh, where their own names do not say it.
std::string Nodes::definition_of(const tinygltf::Node& node) const {
  const Users& users = users_.at(node.mesh);
  if (users.count < 2 || (users.stem && !users.stem->empty())) return {};
  return clean_name(model_.meshes[static_cast<std::size_t>(node.mesh)].name);
}

void Nodes::emit(const Visit& visit) {
  source_.context().check();
  const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(visit.node)];
  if (node.mesh >= 0 && static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) {
    ++missing_;
    return;
  }
  const auto global = [&](int joint) {
    const auto index = static_cast<std::size_t>(joint);
    return joint >= 0 && index < place_.size() ? place_[index] : Placement{};
  };
  const std::vector<MeshShape>& shapes = meshes_.of(node, global);
  if (shapes.empty()) return;
  const bool skinned = meshes_.has_skin(node);
  for (const Placement& instance : instances(node)) {
    const Placement place = skinned ? Placement{} : after(visit.place, instance);
    for (const MeshShape& shape : shapes) {
      if (file_.uses.size() == kMostUses) {
        source_.fail("shows more than 1,000,000 meshes; it is damaged or hostile");
      }
      MeshUse use{.object = shape.object,
                  .place = in_mm(place),
                  .name = name_of(visit),
                  .assembly = visit.above,
                  .color = shape.look.color,
                  .definition = definition_of(node),
                  .opacity = shape.look.opacity};
      if (!shape.material.empty()) {
        use.name = use.name.empty() ? shape.material : use.name + " " + shape.material;
        use.definition.clear();
      }
      file_.uses.push_back(std::move(use));
    }
  }
}

void Nodes::report() {
  if (meshes_.not_drawn() > 0) {
    file_.diagnostics.add(Severity::Warning, "gltf.no_faces", meshes_.not_drawn(),
                          "lines and points of the glTF, which have no faces, were left out");
  }
  if (missing_ > 0) {
    file_.diagnostics.add(Severity::Warning, "gltf.missing", missing_,
                          "nodes or meshes that the scene of the glTF places are not there; they "
                          "were left out");
  }
  if (model_.scenes.size() > 1) {
    file_.diagnostics.add(Severity::Info, "gltf.other_scenes",
                          static_cast<std::int64_t>(model_.scenes.size()) - 1,
                          "scenes of the glTF other than its default scene were left out");
  }
  if (hidden_ > 0) {
    file_.diagnostics.add(Severity::Info, "gltf.hidden", hidden_,
                          "nodes that the glTF hides were left out, with all below them");
  }
  report_many_colors(meshes_.many_colors(), file_.diagnostics);
}

}  // namespace

MeshFile parts_of(const tinygltf::Model& model, const Source& source) {
  return Nodes(model, source).read();
}

}  // namespace burin::gltf
