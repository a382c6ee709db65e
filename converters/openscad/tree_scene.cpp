#include "tree_scene.h"

#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/repair/repair.h>
#include <burin/surface/placed_form.h>

#include "child.h"
#include "evaluated_part.h"
#include "instances.h"
#include "model_marks.h"
#include "parts.h"
#include "solid_store.h"
#include "text.h"
#include "tree_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

csg::Solid placed(csg::Solid solid, const Placement& place) {
  for (Vec3& p : solid.positions) p = place.point(p);
  if (place.mirrors()) {
    for (auto& t : solid.triangles) std::swap(t[1], t[2]);
  }
  return solid;
}

std::string stem_of(const std::filesystem::path& path) { return clean_name(path.stem().string()); }

/// The next part of a scene, without a form.
Part look_of(const TreePart& of, const std::filesystem::path& path, const Scene& scene) {
  Part part{of.name, path.string(), nullptr};
  if (!of.assembly.empty()) part.assembly = {of.assembly};
  part.joined =
      !of.assembly.empty() && !scene.parts.empty() && scene.parts.back().assembly == part.assembly;
  part.color = of.color;
  part.definition = of.definition;
  // As OpenSCAD shows it, whoever follows the marks of the model or does not.
  constexpr double kShown = 0.5;
  part.opacity = of.background ? std::min(of.opacity, kShown) : of.opacity;
  return part;
}

/// What the model asks of the drawing of those parts that came out.
void add_marks(const TreeParts& planned, const std::vector<bool>& made,
               const std::filesystem::path& path, ReadResult& out) {
  ModelMarks marks = marks_of(planned, made, out.scene.diagnostics);
  if (marks.empty()) return;
  marks.source = path.string();
  out.marks.push_back(std::move(marks));
}

}  // namespace

ReadResult scene_of_tree(const csg::Tree& tree, const TreeCalls& calls, std::string_view program,
                         const std::filesystem::path& path, const OpenscadOptions& options,
                         TreeShapes shapes, RunContext& context) {
  ReadResult out;
  Scene& scene = out.scene;
  report_undefined_places(tree, scene.diagnostics);
  SolidStore store(tree, path, context);
  const std::string stem = stem_of(path);
  const CallParts instances = instances_of(tree, calls, program, stem, store, scene.diagnostics);
  const TreeParts planned = parts_of(tree, program, stem, scene.diagnostics, instances);
  const std::vector<StoredPart> stored = store.store(planned.parts, scene.diagnostics);
  std::map<std::size_t, Placer> forms;
  std::vector<bool> made;
  for (std::size_t i = 0; i < planned.parts.size(); ++i) {
    const TreePart& of = planned.parts[i];
    const csg::Solid& solid = store.solid(stored[i]);
    made.push_back(!solid.empty());
    if (solid.empty()) continue;
    Part part = look_of(of, path, scene);
    const Placement& place = stored[i].place;
    if (shapes == TreeShapes::Meshes) {
      part.form =
          form_of(placed(solid, place), Facets::Flat, part.name, scene.diagnostics, context);
    } else {
      const Facets facets = !options.round                 ? Facets::Flat
                            : has_unknown_facets(tree, of) ? Facets::Judged
                                                           : Facets::Known;
      auto form = forms.find(stored[i].solid);
      if (form == forms.end()) {
        form = forms
                   .emplace(stored[i].solid,
                            form_of(solid, facets, part.name, scene.diagnostics, context))
                   .first;
      }
      part.form = form->second.at(place);
    }
    scene.parts.push_back(std::move(part));
  }
  add_marks(planned, made, path, out);
  return out;
}

ReadResult functions_of_tree(const csg::Tree& tree, const TreeCalls& calls,
                             std::string_view program, const std::filesystem::path& path,
                             RunContext& context) {
  ReadResult out;
  Scene& scene = out.scene;
  report_undefined_places(tree, scene.diagnostics);
  const TreeParts planned = parts_of(tree, program, stem_of(path), scene.diagnostics, {&calls});
  for (const TreePart& part : planned.parts) {
    const auto fail = [&](const char* what) {
      throw InputError(fmt::format("{}: {}", part.name, what), path.string());
    };
    try {
      auto form = std::make_shared<ImplicitForm>(make_function(function_of(tree, part, context)),
                                                 std::nullopt, context);
      Part made = look_of(part, path, scene);
      made.form = std::move(form);
      scene.parts.push_back(std::move(made));
    } catch (const GeometryError& e) {
      fail(e.what());
    } catch (const UsageError& e) {
      fail(e.what());
    }
  }
  add_marks(planned, std::vector<bool>(planned.parts.size(), true), path, out);
  return out;
}

OpenscadMesh whole_of_tree(const csg::Tree& tree, const std::filesystem::path& path,
                           RunContext& context) {
  constexpr std::uint32_t kAll = 0;
  OpenscadMesh out;
  csg::ChildOptions options = evaluation_of(path);
  // Of a tree that is the user's own file lines can be named.
  const bool of_file = lowered(path.extension().string()) == ".csg";
  options.where = [&](std::int64_t line) {
    return of_file ? fmt::format("line {}", line) : std::string();
  };
  report_undefined_places(tree, out.diagnostics);
  csg::Solid solid = std::move(
      csg::evaluate_in_child(tree.source, {&kAll, 1}, options, context, out.diagnostics).front());
  if (solid.empty()) return out;
  out.mesh = repaired(solid, "", out.diagnostics, context);
  return out;
}

}  // namespace burin::detail
