#include "../formats.h"
#include "model.h"
#include "package.h"
#include "shapes.h"
#include "slicer.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t kDeepestComponent = 64;  // components inside components
constexpr std::size_t kMostComponents =
    100'000;  // a few lines of components can ask for 2^60 objects
constexpr std::size_t kMostTriangles = 100'000'000;

/// What stands above an object on the way down from an item of the build.
struct Above {
  std::string path;  // the model part that uses the object
  Placement place = {};
  std::vector<std::string> names = {};  // some may be empty
  /// What a slicer says of the item, and of the component that is on the way.
  const SlicerObject* item = nullptr;
  const SlicerPart* part = nullptr;
};

/// A mesh where it stands: a part that has no name yet.
struct Leaf {
  MeshUse use;
  std::vector<std::string> above;  // the names of all that contains it
  std::string own, by_slicer;      // its name in the model, and in a slicer's settings
};

class ThreeMfReader {
 public:
  explicit ThreeMfReader(const Source& source)
      : source_(source), package_(source, "3MF archive"), slicer_(read_slicer_settings(package_)) {}
  MeshFile read();

 private:
  std::string root_path() const;
  const ThreeMfModel& model(const std::string& path);
  const ThreeMfObject* object(const std::string& path, const std::string& id);
  void item(const ThreeMfUse& use, const std::string& root);
  void walk(const ThreeMfUse& use, const Above& above, std::size_t depth);
  void components(const ThreeMfObject& object, const Above& inside, std::size_t depth);
  void mesh(const ThreeMfUse& use, const ThreeMfObject& object, const Above& above);
  void leaf(const ThreeMfUse& use, const ThreeMfObject& object, const Above& above,
            const SlicerPart* volume);
  void name_leaves(const SlicerObject* slicer);
  void report();

  const Source& source_;
  Package package_;
  std::map<std::string, SlicerObject> slicer_;
  std::map<std::string, ThreeMfModel> models_;
  ThreeMfShapes shapes_;
  std::vector<Leaf> leaves_;  // of the item under way
  std::size_t uses_ = 0, triangles_ = 0;
  std::int64_t supports_ = 0, not_solid_ = 0, beams_ = 0, missing_ = 0, not_printed_ = 0;
  std::string first_missing_;
  MeshFile file_;
};

std::string ThreeMfReader::root_path() const {
  if (package_.has("_rels/.rels")) {
    std::string path = find_3mf_root(package_.read("_rels/.rels"), source_);
    if (!path.empty()) return path;
  }
  for (const std::string& name : package_.names()) {
    if (lowered(name).ends_with(".model")) return name;
  }
  if (package_.has("Document.xml"))
    source_.fail("is a FreeCAD document, not a 3MF file; give it the suffix .FCStd");
  source_.fail("is a zip archive without a 3MF model; unpack it or export the model again");
}

const ThreeMfModel& ThreeMfReader::model(const std::string& path) {
  const auto found = models_.find(path);
  if (found != models_.end()) return found->second;
  return models_.emplace(path, parse_3mf_model(package_.read(path), path, source_)).first->second;
}

/// Null where the package does not hold it; the reader reports it at the end.
const ThreeMfObject* ThreeMfReader::object(const std::string& path, const std::string& id) {
  const bool there = models_.contains(path) || package_.has(path);
  if (there) {
    const auto& objects = model(path).objects;
    if (const auto found = objects.find(id); found != objects.end()) return &found->second;
  }
  if (missing_++ == 0) {
    const std::string_view name = std::string_view(path).substr(path.starts_with('/') ? 1 : 0);
    first_missing_ = there ? fmt::format("object {} of {}", in_quotes(id), name)
                           : fmt::format("the model part {}", name);
  }
  return nullptr;
}

void ThreeMfReader::leaf(const ThreeMfUse& use, const ThreeMfObject& object, const Above& above,
                         const SlicerPart* volume) {
  const std::size_t shape =
      shapes_.add(above.path, use.object, object, model(above.path).unit, volume);
  triangles_ += shapes_.triangles(shape);
  if (triangles_ > kMostTriangles) {
    source_.fail(
        fmt::format("the components of the 3MF ask for more than {} triangles; it is damaged or "
                    "hostile",
                    kMostTriangles));
  }
  Appearance look = shapes_.look(shape);
  const SlicerPart* part = volume ? volume : above.part;
  const std::optional<Rgba> filament = part         ? part->color
                                       : above.item ? above.item->color
                                                    : std::nullopt;
  if (look.color.empty() && filament) look = look_of(*filament);
  leaves_.push_back({{.object = shape,
                      .place = above.place,
                      .color = std::move(look.color),
                      .opacity = look.opacity},
                     above.names,
                     object.name,
                     part ? part->name : std::string()});
}

void ThreeMfReader::mesh(const ThreeMfUse& use, const ThreeMfObject& object, const Above& above) {
  const bool volumes = above.item && !above.part && !above.item->parts.empty() &&
                       above.item->parts.front().id.empty();
  if (!volumes) return leaf(use, object, above, nullptr);
  for (const SlicerPart& volume : above.item->parts) {
    if (volume.first > volume.last || volume.first >= object.mesh.polygon_count()) continue;
    if (!volume.solid) {
      ++not_solid_;
    } else {
      leaf(use, object, above, above.item->parts.size() > 1 ? &volume : nullptr);
    }
  }
}

void ThreeMfReader::components(const ThreeMfObject& object, const Above& inside,
                               std::size_t depth) {
  for (const ThreeMfUse& c : object.components) {
    Above of_component = inside;
    if (inside.item) {
      const auto& parts = inside.item->parts;
      const auto part = std::ranges::find(parts, c.object, &SlicerPart::id);
      if (part != parts.end()) of_component.part = &*part;
      if (part != parts.end() && !part->solid) {
        ++not_solid_;
        continue;
      }
    }
    walk(c, of_component, depth + 1);
  }
}

void ThreeMfReader::walk(const ThreeMfUse& use, const Above& above, std::size_t depth) {
  source_.context().check();
  if (depth > kDeepestComponent || ++uses_ > kMostComponents) {
    source_.fail(
        "the components of the 3MF contain each other or are far too many; it is damaged or "
        "hostile");
  }
  Above here = above;
  if (!use.path.empty()) here.path = use.path;
  const ThreeMfObject* found = object(here.path, use.object);
  if (found == nullptr) return;
  const ThreeMfObject& object = *found;
  if (!object.is_model()) {
    ++supports_;
    return;
  }
  beams_ += object.has_beams;
  Placement place = use.place;
  place.offset *= model(here.path).unit;
  here.place = after(above.place, place);
  if (object.mesh.polygon_count() > 0) mesh(use, object, here);
  here.names.push_back(object.name);
  components(object, here, depth);
}

/// One part of an item is called as the item is; several as they are themselves, in an assembly of
/// the item's name.
void ThreeMfReader::name_leaves(const SlicerObject* slicer) {
  const auto first_of = [](std::initializer_list<std::string> names) {
    const auto named = std::ranges::find_if(names, [](const auto& n) { return !n.empty(); });
    return named == names.end() ? std::string() : *named;
  };
  const std::string item = slicer ? slicer->name : std::string();
  const bool several = leaves_.size() > 1;
  for (Leaf& leaf : leaves_) {
    if (!leaf.above.empty() && !item.empty()) leaf.above.front() = item;
    std::erase(leaf.above, std::string());
    const std::string nearest = leaf.above.empty() ? item : leaf.above.back();
    leaf.use.name = several ? first_of({leaf.by_slicer, leaf.own, nearest})
                            : first_of({item, leaf.own, nearest, leaf.by_slicer});
    const bool named = !(leaf.by_slicer.empty() && leaf.own.empty());
    if (several && named) {
      if (leaf.above.empty() && !item.empty()) leaf.above.push_back(item);
      for (const std::string& name : leaf.above) leaf.use.assembly.push_back(clean_name(name));
    }
    file_.uses.push_back(std::move(leaf.use));
  }
  leaves_.clear();
}

void ThreeMfReader::item(const ThreeMfUse& use, const std::string& root) {
  const auto slicer = use.path.empty() ? slicer_.find(use.object) : slicer_.end();
  const SlicerObject* of_item = slicer == slicer_.end() ? nullptr : &slicer->second;
  walk(use, {.path = root, .item = of_item}, 0);
  name_leaves(of_item);
}

void ThreeMfReader::report() {
  if (supports_ > 0) {
    file_.diagnostics.add(Severity::Info, "3mf.supports", supports_,
                          "support objects, which are no part of the model, were left out");
  }
  if (not_solid_ > 0) {
    file_.diagnostics.add(Severity::Info, "3mf.modifiers", not_solid_,
                          "volumes that a slicer uses to modify others, or to place supports, were "
                          "left out");
  }
  if (not_printed_ > 0) {
    file_.diagnostics.add(Severity::Info, "3mf.not_printable", not_printed_,
                          "items that the file marks as not to be printed were left out");
  }
  if (beams_ > 0) {
    file_.diagnostics.add(
        Severity::Warning, "3mf.beams", beams_,
        "beam lattices were left out: they are no triangles; export them as such");
  }
  if (missing_ > 0) {
    file_.diagnostics.add(Severity::Warning, "3mf.missing", missing_,
                          fmt::format("items or components were left out: the file does not hold "
                                      "what they place; the first: {}",
                                      first_missing_));
  }
  report_many_colors(shapes_.many_colors(), file_.diagnostics);
}

MeshFile ThreeMfReader::read() {
  file_.format = "3MF";
  const std::string path = root_path();
  const ThreeMfModel& root = model(path);
  if (root.build.empty()) {
    for (const std::string& id : root.order) {
      if (root.objects.at(id).mesh.polygon_count() > 0) item({.object = id}, path);
    }
    if (!shapes_.empty()) {
      file_.diagnostics.add(Severity::Info, "3mf.no_build", 1,
                            "the build section of the 3MF is empty; all of its objects are drawn");
    }
  }
  // Where nothing is to be printed, the file was not saved for that.
  const bool some = std::ranges::any_of(root.build, &ThreeMfUse::printable);
  for (const ThreeMfUse& use : root.build) {
    if (use.printable || !some) {
      item(use, path);
    } else {
      ++not_printed_;
    }
  }
  if (shapes_.empty()) {
    if (missing_ > 0)
      source_.fail(fmt::format("the 3MF does not hold {}, which its build uses; export it again",
                               first_missing_));
    source_.fail(supports_ > 0 ? "the 3MF holds support objects alone; export the model itself"
                               : "the 3MF holds no triangles; export it again");
  }
  report();
  file_.polygon_colors = shapes_.take_colors();
  file_.objects = shapes_.take();
  return std::move(file_);
}

}  // namespace

MeshFile read_3mf(const Source& source) { return ThreeMfReader(source).read(); }

}  // namespace burin
