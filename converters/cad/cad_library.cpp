#include "cad_library.h"

#include <burin/base/error.h>
#include <burin/base/version.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>

#include "cad_file.h"
#include "collect.h"
#include "measure.h"
#include "occt_session.h"
#include "shape_in_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// The models of what parts are made of, each made once. Bodies at which OCCT or the form fails are
/// left out and told.
class Models {
 public:
  Models(const OcctSession& session, std::string file, Diagnostics& diagnostics)
      : session_(session), file_(std::move(file)), diagnostics_(diagnostics) {}

  /// What a part is made of, the number that instances share, and which of its bodies these are.
  struct Made {
    std::size_t number = 0;
    std::shared_ptr<const std::vector<BrepBody>> bodies;
    std::vector<std::size_t> from;
  };

  /// Throws GeometryError, InputError where all bodies fail.
  const Made& of(const CadPart& part) {
    const Key key = key_of(*part.bodies);
    const auto it = known_.find(key);
    if (it != known_.end()) return it->second;
    Made made = make(part);
    made.number = known_.size();
    return known_[key] = std::move(made);
  }

 private:
  using Key = std::pair<const void*, TopAbs_Orientation>;

  /// A body alone may stand in several products.
  static Key key_of(const std::vector<CadBody>& bodies) {
    if (bodies.size() > 1) return {&bodies, TopAbs_FORWARD};
    return {bodies.front().shape.TShape().get(), bodies.front().shape.Orientation()};
  }

  Made make(const CadPart& part) {
    Made made;
    std::vector<BrepBody> bodies;
    FirstNumbers first;
    const bool alone = part.bodies->size() == 1;
    for (std::size_t i = 0; i < part.bodies->size(); ++i) {
      const CadBody& body = (*part.bodies)[i];
      try {
        session_.guarded(file_, [&] {
          const TopoDS_Shape shape = body.shape.Located(TopLoc_Location());
          // Of a body alone the place is that of the part: it may be an instance of another.
          bodies.push_back({make_brep_model(shape, first),
                            alone ? Placement() : placement_of(body.shape.Location())});
        });
      } catch (const GeometryError& e) {
        if (is_last(bodies, i, part)) throw;
        report(part.name + "/" + body.name, e);
        continue;
      } catch (const InputError& e) {
        if (is_last(bodies, i, part)) throw;
        report(part.name + "/" + body.name, e);
        continue;
      }
      const BrepCounts counts = bodies.back().model->counts();
      first.face += static_cast<std::int32_t>(counts.faces);
      first.edge += static_cast<std::int32_t>(counts.edges);
      made.from.push_back(i);
    }
    made.bodies = std::make_shared<const std::vector<BrepBody>>(std::move(bodies));
    return made;
  }

  /// Whether nothing is left of the part where this body fails too.
  static bool is_last(const std::vector<BrepBody>& made, std::size_t i, const CadPart& part) {
    return made.empty() && i + 1 == part.bodies->size();
  }

  void report(const std::string& name, const std::exception& e) {
    diagnostics_.add(Severity::Error, "cad.broken_part", 1,
                     fmt::format("{}: the body was left out: {}", name, e.what()));
  }

  const OcctSession& session_;
  std::string file_;
  Diagnostics& diagnostics_;
  std::map<Key, Made> known_;
};

/// Where a part stands whose body alone may have a place of its own.
Placement place_of(const CadPart& part) {
  if (part.bodies->size() > 1) return part.placement;
  return after(part.placement, placement_of(part.bodies->front().shape.Location()));
}

/// Calls `one(part)` for each part of a file; parts at which OCCT or the form fails are left out.
/// Throws InputError where that befalls all of them.
template <class F>
void for_parts(CadFile& file, const OcctSession& session, const std::string& path,
               Diagnostics& diagnostics, const RunContext& context, const F& one) {
  std::string first;
  std::int64_t failures = 0;
  for (CadPart& part : file.parts) {
    context.check();
    const auto fail = [&](const std::exception& e) {
      if (failures++ == 0) first = e.what();
      diagnostics.add(Severity::Error, "cad.broken_part", 1,
                      fmt::format("{}: the part was left out: {}", part.name, e.what()));
    };
    try {
      session.guarded(path, [&] { one(part); });
    } catch (const InputError& e) {
      fail(e);
    } catch (const GeometryError& e) {
      fail(e);
    }
  }
  if (failures == static_cast<std::int64_t>(file.parts.size())) throw InputError(first, path);
}

/// The colours of parts that have several, those of instances made once.
class Paints {
 public:
  CadPaint of(const CadPart& part, const std::vector<std::size_t>& bodies) {
    if (!part.faces) return part.painted(bodies);
    Key key{part.faces.get(), bodies, {}};
    for (const Appearance& color : part.colors) std::get<2>(key).push_back(color_text(color));
    const auto [at, is_new] = known_.try_emplace(std::move(key));
    if (is_new) at->second = part.painted(bodies);
    return at->second;
  }

 private:
  using Key = std::tuple<const void*, std::vector<std::size_t>, std::vector<std::string>>;
  std::map<Key, CadPaint> known_;
};

/// The bodies of a part that can be chosen one by one.
std::vector<Piece> pieces_of(const CadPart& part, const Models::Made& made,
                             const Placement& place) {
  std::vector<Piece> pieces;
  if (made.bodies->size() < 2) return pieces;
  for (std::size_t i = 0; i < made.bodies->size(); ++i) {
    const BrepBody& body = (*made.bodies)[i];
    CadPaint paint = part.painted(made.from, i);
    pieces.push_back({(*part.bodies)[made.from[i]].name,
                      std::make_shared<BrepForm>(body.model, after(place, body.placement)),
                      std::move(paint.look.color), paint.look.opacity, std::move(paint.faces)});
  }
  return pieces;
}

std::shared_ptr<const Form> form_of(const Models::Made& made, const Placement& place) {
  if (made.bodies->size() > 1) return std::make_shared<BrepBodiesForm>(made.bodies, place);
  const BrepBody& body = made.bodies->front();
  return std::make_shared<BrepForm>(body.model, after(place, body.placement));
}

Scene read_scene(const std::filesystem::path& path, const CadReadOptions& options,
                 RunContext& context) {
  const OcctSession session;
  CadFile file = read_cad_file(path, options, session, context);
  Scene scene;
  scene.diagnostics = std::move(file.diagnostics);
  Models models(session, path.string(), scene.diagnostics);
  Paints paints;
  for_parts(file, session, path.string(), scene.diagnostics, context, [&](CadPart& cad) {
    const Models::Made& made = models.of(cad);
    const Placement place = place_of(cad);
    CadPaint paint = paints.of(cad, made.from);
    Part part{std::move(cad.name),         path.string(),
              form_of(made, place),        std::move(cad.assembly),
              std::move(paint.look.color), std::move(cad.definition)};
    part.opacity = paint.look.opacity;
    part.face_colors = std::move(paint.faces);
    part.pieces = pieces_of(cad, made, place);
    if (cad.pmi) part.pmi = {cad.pmi, cad.placement};
    scene.parts.push_back(std::move(part));
  });
  if (options.pmi && std::ranges::none_of(scene.parts, [](const Part& part) {
        return static_cast<bool>(part.pmi);
      })) {
    scene.diagnostics.add(Severity::Warning, "pmi.none", 1,
                          "the file carries no dimensions, tolerances or notes to draw; export it "
                          "as STEP AP242 with PMI");
  }
  return scene;
}

FileInfo inspect(const std::filesystem::path& path, const CadReadOptions& options,
                 RunContext& context) {
  const OcctSession session;
  CadFile file = read_cad_file(path, options, session, context);
  FileInfo info;
  info.file = path.string();
  info.format = std::move(file.format);
  info.schema = std::move(file.schema);
  info.diagnostics = std::move(file.diagnostics);
  Models models(session, info.file, info.diagnostics);
  std::map<std::size_t, std::int32_t> first;  // part of each model
  Paints paints;
  for_parts(file, session, info.file, info.diagnostics, context, [&](CadPart& part) {
    const Models::Made& made = models.of(part);
    PartInfo p = measure(*made.bodies, place_of(part));
    const auto [it, is_new] =
        first.try_emplace(made.number, static_cast<std::int32_t>(info.parts.size()));
    if (!is_new) p.same_shape_as = it->second;
    p.name = std::move(part.name);
    p.assembly = std::move(part.assembly);
    CadPaint paint = paints.of(part, made.from);
    p.colors = count_colors(paint.look.color, paint.faces.get());
    p.color = std::move(paint.look.color);
    p.opacity = paint.look.opacity;
    p.pmi = std::move(part.pmi);
    info.parts.push_back(std::move(p));
  });
  return info;
}

constexpr CadLibrary kLibrary{BURIN_CAD_VERSION,   read_scene,           inspect,
                              read_text_in_memory, read_shape_in_memory, trimmed_faces_in_memory};

}  // namespace
}  // namespace burin

extern "C" const burin::CadLibrary* burin_cad_library() { return &burin::kLibrary; }
