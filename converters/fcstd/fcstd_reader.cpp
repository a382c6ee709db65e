#include <burin/assembly/items.h>
#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/cad_reader.h>
#include <burin/converters/fcstd_reader.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/mesh/placed_mesh.h>
#include <burin/surface/thread.h>

#include "bms.h"
#include "numbered_names.h"
#include "recompute.h"
#include "text.h"
#include "threads.h"
#include "walk.h"
#include "xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Path = std::filesystem::path;
using detail::FcUse;

/// Whether a placement does more than turn and move.
bool changes(const Placement& p) {
  constexpr double kOff = 1e-9;
  return p.mirrors() || off_rotation(p.linear) > kOff;
}

/// What is made of a document: parts for a drawing, or what is told of them.
struct Made {
  std::string program;
  std::vector<Part> parts;
  std::vector<PartInfo> infos;
  Diagnostics diagnostics;
};

class Maker {
 public:
  Maker(const Path& path, const FcstdOptions& options, bool measures, RunContext& context)
      : path_(path), options_(options), measures_(measures), context_(context) {}

  Made make() {
    std::optional<detail::TemporaryFolder> folder;
    Path copy;
    if (options_.recompute) {
      { const detail::FcDocument looks_well(path_, {}, context_); }
      folder.emplace();
      copy = detail::recompute(path_, options_.timeout, *folder, made_.diagnostics, context_);
    }
    detail::FcDocuments documents(context_);
    const detail::FcDocument& root = documents.open(path_, copy);
    made_.program = root.program();
    if (root.gui_is_broken()) {
      made_.diagnostics.add(Severity::Warning, "fcstd.broken_colors", 1,
                            "GuiDocument.xml is broken: parts have no colours, and only "
                            "Document.xml states what is hidden");
    }
    detail::FcWalk walk(documents, root, context_);
    if (options_.objects.empty()) {
      walk.visible();
    } else {
      walk.chosen(options_.objects);
    }
    made_.diagnostics.append(walk.diagnostics);
    left_out_ = std::move(walk.left_out);
    for (std::size_t i = 0; i < walk.uses.size(); ++i) {
      context_.check();
      add(walk.uses[i]);
      context_.progress(static_cast<double>(i + 1) / static_cast<double>(walk.uses.size()));
    }
    if (made_.parts.empty()) fail(root, walk.diagnostics);
    left_out_.report(made_.diagnostics);
    name_copies();
    return std::move(made_);
  }

 private:
  /// A member of an archive, read once; without a shape where it is broken or has no face.
  struct Shape {
    std::shared_ptr<const BrepShape> brep;
    std::optional<PolygonSoup> mesh;
    bool empty = false, no_face = false;
    /// The first part that shows it.
    std::int32_t first = -1;
    /// As those of BrepShape; found where faces have several colours.
    std::optional<std::vector<double>> face_areas = {};
  };

  void broken(const FcUse& use, const std::string& why) {
    const std::string message = fmt::format("{}: the object was left out: {}", use.name, why);
    if (first_failure_.empty()) first_failure_ = message;
    made_.diagnostics.add(Severity::Error, "fcstd.broken_shape", 1, message);
  }

  Shape& shape_of(const FcUse& use) {
    const bool brep = !use.shape->shape.empty();
    const std::string& member = brep ? use.shape->shape : use.shape->mesh;
    const auto [it, is_new] = shapes_.try_emplace({use.document, member});
    if (!is_new) return it->second;
    try {
      const std::string bytes = use.document->member(member);
      if (bytes.empty()) {  // an object that was never computed
        it->second.empty = true;
      } else if (brep) {
        const bool binary = lowered(Path(member).extension().string()) == ".bin";
        it->second.brep =
            read_brep_shape(bytes, binary ? BrepBytes::FreecadBinary : BrepBytes::Occt, context_);
      } else {
        PolygonSoup mesh = detail::read_bms(Source(member, bytes, context_));
        it->second.empty = mesh.indices.empty();
        if (!it->second.empty) it->second.mesh = std::move(mesh);
      }
    } catch (const GeometryError&) {
      it->second.no_face = true;
    } catch (const InputError& e) {
      broken(use, e.what());
    }
    return it->second;
  }

  void add(FcUse& use) {
    Shape& shape = shape_of(use);
    if (shape.empty) return detail::leave_out_shapeless(*use.object, use.name, left_out_);
    if (shape.no_face) {
      some_faceless_ = true;
      return detail::leave_out_faceless(use.name, left_out_);
    }
    if (!shape.brep && !shape.mesh) return;  // the reading has said why
    use.name = names_.name(use.assembly, use.name);
    try {
      if (shape.brep) return add_brep(use, shape);
      add_mesh(use, *shape.mesh);
    } catch (const GeometryError& e) {
      broken(use, e.what());
    } catch (const InputError& e) {
      broken(use, e.what());
    }
  }

  void add_brep(const FcUse& use, Shape& shape) {
    const Placement place = use.own ? after(use.placement, shape.brep->own()) : use.placement;
    if (flattens(use, place)) return;
    const PaintedFaces paint = paint_of(use, shape);
    if (measures_) {
      PartInfo info = shape.brep->measure(place);
      info.same_shape_as = shape.first;
      if (shape.first < 0) shape.first = static_cast<std::int32_t>(made_.infos.size());
      push(use, paint, std::move(info));
    }
    push(use, paint, shape.brep->form(place));
    add_threads(use, place);
  }

  /// Those of the holes of a body.
  void add_threads(const FcUse& use, const Placement& place) {
    if (measures_ || !use.object->is_body()) return;
    detail::LostThreads lost;
    for (const Thread& thread : detail::threads_of(*use.document, *use.object, lost)) {
      made_.parts.back().threads.push_back(placed(thread, place));
    }
    for (const std::string& pattern : lost.patterns) {
      if (!unknown_threads_.insert(pattern).second) continue;
      made_.diagnostics.add(Severity::Warning, "fcstd.thread_pattern", 1,
                            fmt::format("{}: it repeats threads along an edge or a face; these "
                                        "copies are not drawn (`thread` draws them; an axis of a "
                                        "sketch or of the body is followed)",
                                        pattern));
    }
    for (const std::string& hole : lost.sizes) {
      if (!unknown_threads_.insert(hole).second) continue;
      made_.diagnostics.add(Severity::Warning, "fcstd.thread_size", 1,
                            fmt::format("{}: the size of its thread is none that is known; the "
                                        "thread is not drawn (`thread` draws it)",
                                        hole));
    }
  }

  /// A list of another length is of another shape.
  static PaintedFaces paint_of(const FcUse& use, Shape& shape) {
    if (!use.look.faces) return {use.look.color, {}};
    if (!shape.face_areas) shape.face_areas = shape.brep->face_areas();
    if (shape.face_areas->size() != use.look.faces->size()) return {use.look.color, {}};
    return painted_faces(*use.look.faces, *shape.face_areas);
  }

  bool flattens(const FcUse& use, const Placement& place) {
    if (is_invertible(place)) return false;
    broken(use, "a scale of 0 flattens it; give the link scales other than 0");
    return true;
  }

  void add_mesh(const FcUse& use, PolygonSoup soup) {
    const Placement place = use.own ? after(use.placement, use.shape->placement) : use.placement;
    if (flattens(use, place)) return;
    soup = placed(std::move(soup), place);
    soup.name = use.name;
    MeshFile file;
    file.objects.push_back(std::move(soup));
    Scene scene = repair_parts(std::move(file), path_, context_);
    for (Diagnostic d : scene.diagnostics.entries()) {
      d.message = use.name + ": " + d.message;
      made_.diagnostics.add(std::move(d));
    }
    const PaintedFaces paint{use.look.color, {}};
    if (measures_) push(use, paint, measure_mesh_part(scene.parts.front(), context_));
    push(use, paint, std::move(scene.parts.front().form));
  }

  void push(const FcUse& use, const PaintedFaces& paint, PartInfo info) {
    info.name = use.name;
    info.assembly = use.assembly;
    info.color = paint.color;
    info.colors = count_colors(paint.color, paint.faces.get());
    info.opacity = use.look.opacity;
    made_.infos.push_back(std::move(info));
  }
  void push(const FcUse& use, const PaintedFaces& paint, std::shared_ptr<const Form> form) {
    made_.parts.push_back({.name = use.name,
                           .source = path_.string(),
                           .form = std::move(form),
                           .assembly = use.assembly,
                           .color = paint.color,
                           .definition = use.definition,
                           .opacity = use.look.opacity,
                           .face_colors = paint.faces});
    pushed_.push_back(&use);
  }

  /// What links call a thing that nobody named is the name of all of it where they agree but for
  /// numbers at the end; where they do not it has its label: it is one item, whatever links say.
  void name_by_links() {
    std::map<std::pair<const detail::FcDocument*, std::string>, std::vector<std::size_t>> uses;
    for (std::size_t i = 0; i < pushed_.size(); ++i) {
      uses[{pushed_[i]->document, pushed_[i]->object->name}].push_back(i);
    }
    for (const auto& [object, of] : uses) {
      const auto by_link = [&](std::size_t i) { return pushed_[i]->named_by_link; };
      const auto first = std::ranges::find_if(of, by_link);
      if (first == of.end()) continue;
      const auto agrees = [&](std::size_t i) {
        return !by_link(i) ||
               instance_stem(pushed_[i]->definition) == instance_stem(pushed_[*first]->definition);
      };
      const bool agree = std::ranges::all_of(of, agrees);
      for (const std::size_t i : of) {
        made_.parts[i].definition = agree ? pushed_[*first]->definition : pushed_[i]->object->label;
      }
    }
  }

  /// A copy of another object, with a shape of its own, is an instance of what that is an instance
  /// of where both are alike; a mirror image may be. What a link has made another thing has the
  /// name of the link.
  void name_copies() {
    name_by_links();
    std::map<std::pair<const detail::FcDocument*, std::string>, std::size_t> parts;
    for (std::size_t i = 0; i < pushed_.size(); ++i) {
      parts.try_emplace({pushed_[i]->document, pushed_[i]->object->name}, i);
    }
    for (std::size_t i = 0; i < pushed_.size(); ++i) {
      const FcUse& use = *pushed_[i];
      Part& part = made_.parts[i];
      if (changes(use.placement) && !use.link.empty() && !is_as_before(use, *part.form)) {
        part.definition = use.link;
      }
      const auto source = parts.find({use.document, use.object->copy_of});
      if (source == parts.end() || source->second == i) continue;
      const Part& of = made_.parts[source->second];
      if (part.form->measure(context_).same(of.form->measure(context_))) {
        part.definition = of.definition;
      }
    }
  }

  /// Whether the shape looks the same without the placement of the link.
  bool is_as_before(const FcUse& use, const Form& form) {
    const Shape& shape = shape_of(use);
    if (!shape.brep) return false;
    return form.measure(context_).same(shape.brep->form({})->measure(context_));
  }

  [[noreturn]] void fail(const detail::FcDocument& root, const Diagnostics& walked) const {
    const std::string file = path_.string();
    if (!first_failure_.empty()) throw InputError(first_failure_, file);
    if (!walked.empty()) throw InputError(walked.entries().front().message, file);
    if (some_faceless_ || !options_.objects.empty()) {
      throw InputError("what is to be drawn has no faces; solids, surfaces and meshes are drawn",
                       file);
    }
    const auto& objects = root.objects();
    const auto hidden = std::find_if(objects.begin(), objects.end(), [](const auto& o) {
      return !(o.shape.empty() && o.mesh.empty()) && !o.is_illustration() &&
             !o.type.starts_with("Sketcher::");
    });
    if (hidden != objects.end()) {
      throw InputError(
          fmt::format("all of its shapes are hidden; show them in FreeCAD, or choose some: "
                      "`object {}`",
                      in_quotes(hidden->label)),
          file);
    }
    const bool drawings = std::any_of(objects.begin(), objects.end(),
                                      [](const auto& o) { return o.is_illustration(); });
    if (!drawings && std::any_of(objects.begin(), objects.end(),
                                 [](const auto& o) { return o.type.starts_with("Sketcher::"); })) {
      throw InputError("holds sketches only, which have no faces; pad or extrude them in FreeCAD",
                       file);
    }
    Diagnostics reported;
    left_out_.report(reported);
    if (!drawings && !reported.empty()) {
      throw InputError("holds nothing to draw; " + reported.entries().front().message, file);
    }
    throw InputError(drawings ? "holds Burin illustrations only, no shapes; draw the document that "
                                "they show"
                              : "holds no shapes or meshes to draw",
                     file);
  }

  const Path& path_;
  const FcstdOptions& options_;
  bool measures_;
  RunContext& context_;
  Made made_;
  std::map<std::pair<const detail::FcDocument*, std::string>, Shape> shapes_;
  /// Of parts that are drawn.
  NumberedNames names_;
  /// What each part is made of.
  std::vector<const FcUse*> pushed_;
  detail::LeftOut left_out_;
  std::set<std::string> unknown_threads_;
  bool some_faceless_ = false;
  std::string first_failure_;
};

}  // namespace

bool is_fcstd_suffix(const Path& path) { return model_suffix(path) == ".fcstd"; }

bool is_fcstd_content(std::string_view head) {
  constexpr std::size_t kName = 30;  // bytes of a local header before the name
  return head.starts_with(std::string_view("PK\3\4", 4)) && head.size() > kName &&
         head.substr(kName).starts_with("Document.xml");
}

Scene read_fcstd(const Path& path, const FcstdOptions& options, RunContext& context) {
  Made made = Maker(path, options, false, context).make();
  return {std::move(made.parts), std::move(made.diagnostics)};
}

FileInfo inspect_fcstd(const Path& path, const FcstdOptions& options, RunContext& context) {
  Made made = Maker(path, options, true, context).make();
  FileInfo info;
  info.file = path.string();
  info.format = std::move(made.program);
  info.parts = std::move(made.infos);
  info.diagnostics = std::move(made.diagnostics);
  return info;
}

}  // namespace burin
