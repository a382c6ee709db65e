#include "tree_scene.h"

#include <burin/base/error.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/repair/repair.h>
#include <burin/surface/placed_form.h>

#include "affine.h"
#include "child.h"
#include "evaluated_part.h"
#include "parts.h"
#include "text.h"
#include "tree_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace burin::detail {
namespace {

/// A placement within what six digits leave of a matrix; nothing where it does more than turn,
/// mirror, move and scale alike in all directions.
std::optional<Placement> placement_of(const csg::Matrix& m) {
  constexpr double kDigits = 3e-6;  // of numbers up to 1
  const Affine by(m);
  const double scale = std::cbrt(std::abs(glm::determinant(by.linear)));
  if (!(scale > 0) || off_rotation(by.linear / scale) > kDigits) return std::nullopt;
  // The nearest rotation, by Newton's method for the polar decomposition.
  Mat3 turn = by.linear / scale;
  for (int i = 0; i < 4; ++i) turn = 0.5 * (turn + glm::transpose(glm::inverse(turn)));
  return Placement{scale * turn, by.offset};
}

std::string matrix_text(const csg::Matrix& m) {
  std::string text = "multmatrix([";
  for (const auto& row : m.row) {
    text += fmt::format("[{},{},{},{}],", row[0], row[1], row[2], row[3]);
  }
  return text + "[0,0,0,1]])";
}

/// A part as the text of what it is an instance of, and where that stands.
struct Instance {
  std::string text;
  /// How many nodes the text has.
  std::uint32_t nodes = 0;
  Placement place;
};

Instance instance_of(const csg::Tree& tree, const TreePart& part) {
  Instance out;
  for (const TreePart::Piece& piece : part.pieces) {
    out.nodes += tree.nodes[piece.node].end - piece.node;
  }
  if (part.pieces.size() == 1) {
    if (const auto place = placement_of(part.pieces.front().at)) {
      out.place = *place;
      out.text = std::string(tree.text_of(part.pieces.front().node));
      return out;
    }
  }
  for (const TreePart::Piece& piece : part.pieces) {
    const std::string_view text = tree.text_of(piece.node);
    if (piece.at == csg::Matrix{}) {
      out.text += text;
    } else {
      out.text += fmt::format("{}{{{}}}", matrix_text(piece.at), text);
      ++out.nodes;
    }
    out.text += '\n';
  }
  return out;
}

csg::Solid placed(csg::Solid solid, const Placement& place) {
  for (Vec3& p : solid.positions) p = place.point(p);
  if (place.mirrors()) {
    for (auto& t : solid.triangles) std::swap(t[1], t[2]);
  }
  return solid;
}

csg::ChildOptions evaluation_of(const std::filesystem::path& path) {
  csg::ChildOptions options;
  options.folder = std::filesystem::absolute(path).parent_path();
  options.file = path.string();
  return options;
}

}  // namespace

Scene scene_of_tree(const csg::Tree& tree, std::string_view program,
                    const std::filesystem::path& path, const OpenscadOptions& options,
                    Shapes shapes, RunContext& context) {
  Scene scene;
  const TreeParts planned =
      parts_of(tree, program, clean_name(path.stem().string()), scene.diagnostics);
  // One text of what has to be evaluated, each once, and the numbers of its objects.
  std::string text;
  std::vector<std::uint32_t> objects;
  std::uint32_t next = 1;
  std::map<std::string, std::size_t> known;
  std::vector<std::size_t> shape;
  std::vector<Placement> place;
  for (const TreePart& part : planned.parts) {
    Instance instance = instance_of(tree, part);
    const auto [entry, fresh] = known.try_emplace(std::move(instance.text), known.size());
    if (fresh) {
      text += fmt::format("group(){{\n{}}}\n", entry->first);
      objects.push_back(next);
      next += 1 + instance.nodes;
    }
    shape.push_back(entry->second);
    place.push_back(instance.place);
  }
  known.clear();
  const std::vector<csg::Solid> solids =
      csg::evaluate_in_child(text, objects, evaluation_of(path), context, scene.diagnostics);
  std::vector<std::optional<Placer>> forms(solids.size());
  for (std::size_t i = 0; i < planned.parts.size(); ++i) {
    const csg::Solid& solid = solids[shape[i]];
    if (solid.empty()) continue;
    Part part{planned.parts[i].name, path.string(), nullptr};
    part.color = planned.parts[i].color;
    if (shapes == Shapes::Meshes) {
      part.form =
          form_of(placed(solid, place[i]), Facets::Flat, part.name, scene.diagnostics, context);
    } else {
      const Facets facets = !options.round                               ? Facets::Flat
                            : has_unknown_facets(tree, planned.parts[i]) ? Facets::Judged
                                                                         : Facets::Known;
      std::optional<Placer>& form = forms[shape[i]];
      if (!form) form.emplace(form_of(solid, facets, part.name, scene.diagnostics, context));
      part.form = form->at(place[i]);
    }
    scene.parts.push_back(std::move(part));
  }
  if (!planned.settings.empty()) scene.settings.push_back({planned.settings, path.string()});
  return scene;
}

Scene functions_of_tree(const csg::Tree& tree, std::string_view program,
                        const std::filesystem::path& path, RunContext& context) {
  Scene scene;
  const TreeParts planned =
      parts_of(tree, program, clean_name(path.stem().string()), scene.diagnostics);
  for (const TreePart& part : planned.parts) {
    const auto fail = [&](const char* what) {
      throw InputError(fmt::format("{}: {}", part.name, what), path.string());
    };
    try {
      auto form = std::make_shared<ImplicitForm>(make_function(function_of(tree, part, context)),
                                                 std::nullopt, context);
      scene.parts.push_back({part.name, path.string(), std::move(form)});
      scene.parts.back().color = part.color;
    } catch (const GeometryError& e) {
      fail(e.what());
    } catch (const UsageError& e) {
      fail(e.what());
    }
  }
  if (!planned.settings.empty()) scene.settings.push_back({planned.settings, path.string()});
  return scene;
}

OpenscadMesh whole_of_tree(const csg::Tree& tree, const std::filesystem::path& path,
                           RunContext& context) {
  constexpr std::uint32_t kAll = 0;
  OpenscadMesh out;
  csg::Solid solid = std::move(
      csg::evaluate_in_child(tree.source, {&kAll, 1}, evaluation_of(path), context, out.diagnostics)
          .front());
  if (solid.empty()) return out;
  out.mesh = repair(soup_of(solid), {}, out.diagnostics, context);
  return out;
}

}  // namespace burin::detail
