#include <burin/base/affine.h>
#include <burin/base/input_name.h>
#include <burin/base/near_turn.h>
#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/placed_mesh.h>
#include <burin/repair/repair.h>
#include <burin/surface/placed_form.h>

#include "given_name.h"
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

  std::shared_ptr<const Form> form_of(PolygonSoup soup, const std::string& name) {
    Diagnostics diagnostics;
    std::shared_ptr<const Form> form;
    try {
      drop_empty_texture(soup);
      auto texture = texture_of(soup, context_);
      report_partly_textured(soup, diagnostics);
      TriMesh mesh = repair(std::move(soup), {}, diagnostics, context_);
      form = std::make_shared<MeshForm>(std::move(mesh), std::move(texture));
    } catch (const GeometryError& e) {
      if (first_failure_.empty()) first_failure_ = e.what();
      diagnostics.add(Severity::Error, "mesh.empty_part", 1,
                      "the part was left out: " + std::string(e.what()));
    }
    append(scene_.diagnostics, diagnostics, name, several_);
    if (!form || facets_ == Facets::Kept) return form;
    return recognised(std::move(form), name, scene_.diagnostics, context_);
  }

  /// The form that all uses of an object share, placed; where it is used once, or becomes flat, its
  /// triangles as they stand.
  std::shared_ptr<const Form> placed_form(const MeshUse& use, const std::string& name) {
    if (uses_[use.object] == 1 || !is_invertible(use.place)) {
      return form_of(placed(taken(use.object), use.place), name);
    }
    Shared& shared = shared_[use.object];
    if (!shared.made) {
      shared.made = true;
      if (auto form = form_of(taken(use.object), name)) shared.placer.emplace(std::move(form));
    } else {
      --left_[use.object];
    }
    return shared.placer ? shared.placer->at(near_turn(use.place).value_or(use.place)) : nullptr;
  }

  void add(MeshUse& use) {
    const std::string name = name_of(use);
    std::shared_ptr<const Form> form = placed_form(use, name);
    if (!form) return;
    scene_.parts.push_back({.name = name,
                            .source = path_.string(),
                            .form = std::move(form),
                            .assembly = std::move(use.assembly),
                            .color = std::move(use.color),
                            .definition = given_name(use.definition),
                            .opacity = use.opacity});
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
