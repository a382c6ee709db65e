#include "parts.h"

#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/repair/repair.h>

#include "color.h"
#include "instances.h"
#include "leftovers.h"
#include "sides.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace burin::irit {
namespace {

/// Shares of the size within which borders of faces are one edge. Each surface of a model has a
/// polygon of its own for a border: they run apart by the sagittas of their chords.
constexpr double kFaceWeld = 1e-5, kModelWeld = 1e-3;

/// What the lists around an object hand down to it.
struct Around {
  std::vector<std::string> names;  // of the lists that have one
  std::string color;
};

/// An object with surfaces or polygons of its own.
struct Leaf {
  std::string name;
  std::string color;
  std::size_t order = 0;
  Patches patches;
  std::vector<TrimmedSurface> trimmed;
  double weld = kFaceWeld;
};

struct OrderedPart {
  std::size_t order = 0;
  Part part;
  std::shared_ptr<const BrepShape> shape = {};
};

bool is_yes(const std::string* value) { return value != nullptr && *value != "0"; }

/// The triangles of a strip, all turned the same way.
void add_strip(const std::vector<Vec3>& points, PolygonSoup& soup) {
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), points.begin(), points.end());
  for (std::uint32_t i = 0; i + 2 < points.size(); ++i) {
    const std::uint32_t a = first + i, odd = i % 2;
    for (const std::uint32_t corner : {a + odd, a + 1 - odd, a + 2}) soup.indices.push_back(corner);
    soup.offsets.push_back(soup.indices.size());
  }
}

class PartMaker {
 public:
  PartMaker(const Source& source, const std::filesystem::path& path, const IritReadOptions& options)
      : source_(source), path_(path), options_(options) {}
  Parts make(IritObject root);

 private:
  void list(IritObject& object, const Around& around);
  std::optional<Leaf> leaf(IritObject& object, const Around& around);
  void polygons(const IritObject& object, const Leaf& leaf, const Around& around);
  void trivariates(IritObject& object, const Leaf& leaf, const Around& around);
  void join(const std::vector<Leaf>& leaves, const Around& around, bool named_list);
  std::shared_ptr<const Chart> chart(IritSurface& surface) const;
  void check_surface(const NurbsData& data, std::int64_t line) const;
  std::shared_ptr<const BrepShape> faces(std::vector<TrimmedSurface> trimmed, const Patches& whole,
                                         double weld) const;
  std::string file_name() const { return clean_name(model_stem(path_)); }
  /// The name of the innermost list that has one, taken off the list of names.
  std::string take_name(Around& around) const;

  const Source& source_;
  const std::filesystem::path& path_;
  const IritReadOptions& options_;
  std::size_t order_ = 0;
  std::vector<OrderedPart> parts_;
  Leftovers leftovers_;
  Diagnostics diagnostics_;
};

void PartMaker::check_surface(const NurbsData& data, std::int64_t line) const {
  // Charts hold each span by itself: a few kilobytes of a file could ask for gigabytes.
  constexpr double kMostCoefficients = 2e7;
  const auto coefficients = [](int count, int degree) { return (count - degree) * (degree + 1.0); };
  if (coefficients(data.count_u, data.degree_u) * coefficients(data.count_v, data.degree_v) >
      kMostCoefficients) {
    throw InputError("this surface is too large to be drawn; split it or lower its order",
                     source_.file(), line);
  }
}

/// Patches beside trimmed ones are faces as they are.
std::shared_ptr<const BrepShape> PartMaker::faces(std::vector<TrimmedSurface> trimmed,
                                                  const Patches& whole, double weld) const {
  for (const auto& patch : whole) trimmed.push_back({*nurbs_data(*patch), {}, {}});
  try {
    return make_trimmed_faces(trimmed, weld, source_.file(), source_.context());
  } catch (const GeometryError& e) {
    throw InputError(e.what(), source_.file(), trimmed.front().place.line);
  }
}

std::shared_ptr<const Chart> PartMaker::chart(IritSurface& surface) const {
  check_surface(surface.data, surface.line);
  try {
    return make_nurbs_chart(std::move(surface.data));
  } catch (const GeometryError& e) {
    throw InputError(e.what(), source_.file(), surface.line);
  }
}

std::string PartMaker::take_name(Around& around) const {
  if (around.names.empty()) return file_name();
  std::string name = std::move(around.names.back());
  around.names.pop_back();
  return name;
}

void PartMaker::polygons(const IritObject& object, const Leaf& leaf, const Around& around) {
  PolygonSoup soup;
  for (const IritItem& item : object.items) {
    const auto* polygon = std::get_if<IritPolygon>(&item);
    if (polygon == nullptr || polygon->points.size() < 3) continue;
    if (polygon->kind == IritPolygon::Kind::Strip) {
      add_strip(polygon->points, soup);
    } else if (polygon->kind == IritPolygon::Kind::Polygon) {
      for (const Vec3& p : polygon->points) {
        soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
        soup.positions.push_back(p);
      }
      soup.offsets.push_back(soup.indices.size());
    }
  }
  if (soup.polygon_count() == 0) return;
  Around outer = around;
  const std::string name = leaf.name.empty() ? take_name(outer) : leaf.name;
  Diagnostics diagnostics;
  try {
    TriMesh mesh = repair(std::move(soup), {}, diagnostics, source_.context());
    parts_.push_back({leaf.order,
                      {name, path_.string(), std::make_shared<MeshForm>(std::move(mesh)),
                       outer.names, leaf.color}});
  } catch (const GeometryError& e) {
    diagnostics.add(Severity::Error, "mesh.empty_part", 1,
                    "the part was left out: " + std::string(e.what()));
  }
  for (Diagnostic d : diagnostics.entries()) {
    d.message = fmt::format("{}: {}", name, d.message);
    diagnostics_.add(std::move(d));
  }
}

void PartMaker::trivariates(IritObject& object, const Leaf& leaf, const Around& around) {
  for (IritItem& item : object.items) {
    auto* trivariate = std::get_if<IritTrivariate>(&item);
    if (trivariate == nullptr) continue;
    Around outer = around;
    const std::string name = leaf.name.empty() ? take_name(outer) : leaf.name;
    double level = options_.level;
    if (options_.inside_above) {
      level = -level;
      for (double& c : trivariate->spline.coefficients) c = -c;
    }
    try {
      std::shared_ptr<const Form> form = std::make_shared<ImplicitForm>(
          make_trivariate_function(std::move(trivariate->spline), level), options_.bounds,
          source_.context());
      if (trivariate->placement.moves()) form = form->mapped(trivariate->placement);
      parts_.push_back(
          {leaf.order, {name, path_.string(), std::move(form), outer.names, leaf.color}});
    } catch (const GeometryError& e) {
      throw InputError(e.what(), source_.file(), trivariate->line);
    } catch (const UsageError& e) {
      throw InputError(e.what(), source_.file(), trivariate->line);
    }
  }
}

/// The object's own items; none where nothing of it makes a part of patches.
std::optional<Leaf> PartMaker::leaf(IritObject& object, const Around& around) {
  Leaf leaf{object.name, around.color, order_++, {}, {}, kFaceWeld};
  for (IritItem& item : object.items) {
    source_.context().check();
    if (auto* surface = std::get_if<IritSurface>(&item)) leaf.patches.push_back(chart(*surface));
    if (auto* trimmed = std::get_if<IritTrimmed>(&item)) {
      if (trimmed->model) leaf.weld = kModelWeld;
      for (TrimmedSurface& face : trimmed->faces) {
        check_surface(face.surface, face.place.line);
        leaf.trimmed.push_back(std::move(face));
      }
    }
    leftovers_.add(item, object.line);
  }
  polygons(object, leaf, around);
  trivariates(object, leaf, around);
  if (leaf.patches.empty() && leaf.trimmed.empty()) return std::nullopt;
  return leaf;
}

/// Objects of one list: those without names, and those whose sides fit, are one part.
void PartMaker::join(const std::vector<Leaf>& leaves, const Around& around, bool named_list) {
  if (leaves.empty()) return;
  DisjointSets sets(leaves.size());
  std::vector<Patches> patches;
  std::optional<std::uint32_t> unnamed;
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    patches.push_back(leaves[i].patches);
    if (!leaves[i].name.empty()) continue;
    if (unnamed) sets.join(*unnamed, i);
    unnamed = i;
  }
  join_sides(patches, sets);
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    if (sets.find(i) != i) continue;
    Patches all;
    std::vector<TrimmedSurface> trimmed;
    double weld = kFaceWeld;
    std::string name, color = leaves[i].color;
    std::size_t members = 0;
    for (std::uint32_t k = i; k < leaves.size(); ++k) {
      if (sets.find(k) != i) continue;
      ++members;
      all.insert(all.end(), patches[k].begin(), patches[k].end());
      trimmed.insert(trimmed.end(), leaves[k].trimmed.begin(), leaves[k].trimmed.end());
      weld = std::max(weld, leaves[k].weld);
      if (name.empty()) name = leaves[k].name;
      if (leaves[k].color != color) color.clear();
    }
    Around outer = around;
    const bool whole_list = named_list && members > 1 && members == leaves.size();
    if (name.empty() || whole_list) name = take_name(outer);
    OrderedPart made{leaves[i].order, {name, path_.string(), nullptr, outer.names, color}};
    if (trimmed.empty()) {
      made.part.form = std::make_shared<ParametricForm>(std::move(all), kWeld);
    } else {
      made.shape = faces(std::move(trimmed), all, weld);
      made.part.form = made.shape->form({});
    }
    parts_.push_back(std::move(made));
  }
}

void PartMaker::list(IritObject& object, const Around& around) {
  std::vector<Leaf> leaves;
  const auto keep = [&](std::optional<Leaf> leaf) {
    if (leaf) leaves.push_back(std::move(*leaf));
  };
  if (!object.items.empty()) {
    // Items beside the objects of a list belong to the list itself.
    IritObject own;
    own.items = std::move(object.items);
    own.line = object.line;
    keep(leaf(own, around));
  }
  for (IritObject& child : object.objects) {
    if (is_yes(child.attribute("invisible"))) {
      leftovers_.add_invisible(child.line);
      continue;
    }
    Around inside{around.names, color_of(child).value_or(around.color)};
    if (child.objects.empty()) {
      keep(leaf(child, inside));
      continue;
    }
    if (!child.name.empty()) inside.names.push_back(child.name);
    list(child, inside);
  }
  join(leaves, around, !object.name.empty());
}

Parts PartMaker::make(IritObject root) {
  list(root, {});
  if (parts_.empty()) {
    throw InputError(leftovers_.nothing_else(), source_.file(), leftovers_.first_line());
  }
  std::ranges::stable_sort(parts_, {}, &OrderedPart::order);
  Parts made;
  for (OrderedPart& p : parts_) {
    made.scene.parts.push_back(std::move(p.part));
    made.shapes.push_back(std::move(p.shape));
  }
  made.scene.diagnostics = std::move(diagnostics_);
  leftovers_.report(made.scene.diagnostics);
  return made;
}

}  // namespace

Parts make_parts(IritObject root, const Source& source, const std::filesystem::path& path,
                 const IritReadOptions& options) {
  resolve_instances(root, source);
  return PartMaker(source, path, options).make(std::move(root));
}

Parts make_part(std::vector<NurbsData> patches, const Source& source,
                const std::filesystem::path& path) {
  if (patches.empty()) source.fail("holds no patch; export it again");
  IritObject root;
  for (NurbsData& data : patches) root.items.push_back(IritSurface{std::move(data), {}, 0});
  return make_parts(std::move(root), source, path, {});
}

}  // namespace burin::irit
