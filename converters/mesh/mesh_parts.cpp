#include <burin/base/affine.h>
#include <burin/base/input_name.h>
#include <burin/base/near_turn.h>
#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/placed_mesh.h>
#include <burin/repair/repair.h>
#include <burin/surface/placed_form.h>

#include "given_name.h"
#include "look.h"
#include "painted_mesh.h"
#include "text.h"
#include "texture.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

namespace burin {
namespace {

void report_partly_textured(const PolygonSoup& soup, Diagnostics& diagnostics) {
  const std::int64_t without = polygons_without_texture(soup);
  if (without == 0) return;
  diagnostics.add(Severity::Info, "mesh.partly_textured", without,
                  "faces have no texture coordinates though others of their part have them; laws "
                  "of u and v change nothing there");
}

/// The entries of one part's repair, with the part's name where there are several.
void append(Diagnostics& all, const Diagnostics& part, const std::string& name, bool several) {
  for (Diagnostic d : part.entries()) {
    if (several) d.message = fmt::format("{}: {}", name, d.message);
    all.add(std::move(d));
  }
}

void use_each_once(MeshFile& file) {
  if (!file.uses.empty()) return;
  file.uses.resize(file.objects.size());
  for (std::size_t i = 0; i < file.uses.size(); ++i) file.uses[i].object = i;
}

class Parts {
 public:
  Parts(MeshFile file, const std::filesystem::path& path, Facets facets, const RunContext& context)
      : file_(std::move(file)), path_(path), facets_(facets), context_(context) {
    use_each_once(file_);
    several_ = file_.uses.size() > 1;
    shared_.resize(file_.objects.size());
    file_.polygon_colors.resize(file_.objects.size());
    left_.resize(file_.objects.size());
    for (const MeshUse& use : file_.uses) ++left_[use.object];
    uses_ = left_;
    scene_.diagnostics = std::move(file_.diagnostics);
  }

  Scene make() {
    for (MeshUse& use : file_.uses) {
      context_.check();
      add(use);
    }
    if (scene_.parts.empty()) throw InputError(first_failure_, path_.string());
    return std::move(scene_);
  }

 private:
  /// What several uses have in common; no form where no triangle of it was left.
  struct Shared {
    bool made = false;
    std::optional<Placer> placer;
    PaintedFaces colors;
  };
  struct Made {
    std::shared_ptr<const Form> form;
    PaintedFaces colors;
  };

  std::string name_of(const MeshUse& use) const {
    std::string name = given_name(use.name.empty() ? file_.objects[use.object].name : use.name);
    return name.empty() ? clean_name(model_stem(path_)) : name;
  }

  /// The object for its next use: the last one takes it.
  PolygonSoup taken(std::size_t object) {
    if (--left_[object] == 0) return std::exchange(file_.objects[object], {});
    return file_.objects[object];
  }

  /// `colors`: of the polygons; absent: they look alike.
  Made form_of(PolygonSoup soup, const FaceColors* colors, const std::string& name) {
    Diagnostics diagnostics;
    Made made;
    try {
      drop_empty_texture(soup);
      auto texture = texture_of(soup, context_);
      report_partly_textured(soup, diagnostics);
      const PolygonSoup before = colors ? soup : PolygonSoup();
      TriMesh mesh = repair(std::move(soup), {}, diagnostics, context_);
      PaintedMesh painted = colors ? paint_mesh(mesh, before, *colors, context_) : PaintedMesh();
      made.form =
          std::make_shared<MeshForm>(std::move(mesh), std::move(texture), std::move(painted.faces));
      made.colors = std::move(painted.colors);
    } catch (const GeometryError& e) {
      if (first_failure_.empty()) first_failure_ = e.what();
      diagnostics.add(Severity::Error, "mesh.empty_part", 1,
                      "the part was left out: " + std::string(e.what()));
    }
    append(scene_.diagnostics, diagnostics, name, several_);
    if (!made.form || facets_ == Facets::Kept) return made;
    made.form = recognised(std::move(made.form), name, scene_.diagnostics, context_);
    return made;
  }

  /// The form that all uses of an object share, placed; where it is used once, or becomes flat, its
  /// triangles as they stand.
  Made placed_form(const MeshUse& use, const std::string& name) {
    const FaceColors* colors = file_.polygon_colors[use.object].get();
    if (uses_[use.object] == 1 || !is_invertible(use.place)) {
      return form_of(placed(taken(use.object), use.place), colors, name);
    }
    Shared& shared = shared_[use.object];
    if (!shared.made) {
      shared.made = true;
      Made made = form_of(taken(use.object), colors, name);
      if (made.form) shared.placer.emplace(std::move(made.form));
      shared.colors = std::move(made.colors);
    } else {
      --left_[use.object];
    }
    if (!shared.placer) return {};
    return {shared.placer->at(near_turn(use.place).value_or(use.place)), shared.colors};
  }

  void add(MeshUse& use) {
    const std::string name = name_of(use);
    Made made = placed_form(use, name);
    if (!made.form) return;
    const bool own = !made.colors.color.empty();
    const Appearance look = own ? look_of(made.colors.color) : Appearance{use.color, use.opacity};
    scene_.parts.push_back({.name = name,
                            .source = path_.string(),
                            .form = std::move(made.form),
                            .assembly = std::move(use.assembly),
                            .color = look.color,
                            .definition = given_name(use.definition),
                            .opacity = look.opacity,
                            .face_colors = std::move(made.colors.faces)});
  }

  MeshFile file_;
  const std::filesystem::path& path_;
  Facets facets_;
  const RunContext& context_;
  bool several_ = false;
  std::vector<Shared> shared_;
  /// How many uses each object has, and how many are still to come.
  std::vector<std::size_t> uses_, left_;
  std::string first_failure_;
  Scene scene_;
};

}  // namespace

std::vector<PolygonSoup> placed_objects(MeshFile file) {
  use_each_once(file);
  std::vector<PolygonSoup> out;
  for (const MeshUse& use : file.uses) {
    out.push_back(placed(file.objects[use.object], use.place));
    if (!use.name.empty()) out.back().name = use.name;
  }
  return out;
}

Scene repair_parts(MeshFile file, const std::filesystem::path& path, const RunContext& context,
                   Facets facets) {
  return Parts(std::move(file), path, facets, context).make();
}

}  // namespace burin
