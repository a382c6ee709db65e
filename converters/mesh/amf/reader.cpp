#include <burin/converters/amf_objects.h>

#include "../formats.h"
#include "document.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace burin {
namespace {

using amf::Constellation;
using amf::Instance;
using amf::Object;
using amf::Volume;

constexpr std::size_t kDeepestConstellation = 64;  // constellations inside constellations
constexpr std::size_t kMostInstances = 100'000;    // a few lines can ask for 2^60 objects

class AmfReader {
 public:
  explicit AmfReader(const Source& source) : source_(source), document_(amf::parse(source)) {}
  MeshFile read();

 private:
  void objects();
  void walk(const Instance& use, const Placement& above, std::vector<std::string> names,
            std::size_t depth);
  void show(std::size_t object, const Placement& place, const std::vector<std::string>& above);
  void report();

  /// A volume that is drawn.
  struct Shape {
    std::size_t object = 0;  // in the file that is made
    std::string name;
    Appearance look;
  };
  const Source& source_;
  amf::Document document_;
  std::vector<std::vector<Shape>> shapes_;  // of each object
  std::map<std::string, std::size_t> object_of_, constellation_of_;
  std::set<std::string> used_;
  std::size_t placed_ = 0;
  std::int64_t supports_ = 0, modifiers_ = 0, many_colors_ = 0, missing_ = 0;
  std::string first_missing_;
  MeshFile file_;
};

void AmfReader::objects() {
  for (Object& object : document_.objects) {
    std::vector<Shape>& shapes = shapes_.emplace_back();
    for (Volume& volume : object.volumes) {
      supports_ += volume.support;
      modifiers_ += volume.modifier;
      if (volume.support || volume.modifier || volume.mesh.polygon_count() == 0) continue;
      for (Vec3& p : volume.mesh.positions) p *= document_.unit;
      many_colors_ += volume.look.too_many();
      volume.mesh.name = volume.name.empty() ? object.name : volume.name;
      shapes.push_back({file_.objects.size(), volume.name, volume.look.look()});
      file_.polygon_colors.push_back(volume.look.colors());
      file_.objects.push_back(std::move(volume.mesh));
    }
  }
}

/// One volume is called as the object is; several as they are themselves, in an assembly of its
/// name.
void AmfReader::show(std::size_t object, const Placement& place,
                     const std::vector<std::string>& above) {
  const std::string& name = document_.objects[object].name;
  const std::vector<Shape>& shapes = shapes_[object];
  for (const Shape& shape : shapes) {
    if (file_.uses.size() == kMostInstances) {
      source_.fail(
          "the constellations of the AMF ask for too many objects; it is damaged or "
          "hostile");
    }
    MeshUse use{.object = shape.object,
                .place = place,
                .color = shape.look.color,
                .opacity = shape.look.opacity};
    use.place.offset *= document_.unit;
    for (const std::string& part : above) use.assembly.push_back(clean_name(part));
    if (shapes.size() > 1 && !name.empty() && !shape.name.empty()) {
      use.assembly.push_back(clean_name(name));
    }
    const bool own = name.empty() || (shapes.size() > 1 && !shape.name.empty());
    use.name = clean_name(own ? shape.name : name);
    file_.uses.push_back(std::move(use));
  }
}

void AmfReader::walk(const Instance& use, const Placement& above, std::vector<std::string> names,
                     std::size_t depth) {
  source_.context().check();
  if (depth > kDeepestConstellation || ++placed_ > kMostInstances) {
    source_.fail(
        "the constellations of the AMF contain each other or are far too many; it is damaged or "
        "hostile");
  }
  used_.insert(use.object);
  const Placement place = after(above, use.place);
  if (const auto found = object_of_.find(use.object); found != object_of_.end()) {
    return show(found->second, place, names);
  }
  const auto found = constellation_of_.find(use.object);
  if (found == constellation_of_.end()) {
    if (missing_++ == 0) first_missing_ = in_quotes(use.object);
    return;
  }
  const Constellation& set = document_.constellations[found->second];
  if (!set.name.empty()) names.push_back(set.name);
  for (const Instance& instance : set.instances) walk(instance, place, names, depth + 1);
}

void AmfReader::report() {
  if (supports_ > 0) {
    file_.diagnostics.add(Severity::Info, "amf.supports", supports_,
                          "support volumes, which are no part of the model, were left out");
  }
  if (modifiers_ > 0) {
    file_.diagnostics.add(Severity::Info, "amf.modifiers", modifiers_,
                          "volumes that a slicer uses to modify others were left out");
  }
  if (missing_ > 0) {
    file_.diagnostics.add(Severity::Warning, "amf.missing", missing_,
                          fmt::format("instances were left out: the file does not hold what they "
                                      "place; the first: object {}",
                                      first_missing_));
  }
  report_many_colors(many_colors_, file_.diagnostics);
}

MeshFile AmfReader::read() {
  file_.format = "AMF";
  objects();
  if (file_.objects.empty()) source_.fail("the AMF holds no triangles; export it again");
  std::set<std::string> inner;
  for (std::size_t i = 0; i < document_.objects.size(); ++i) {
    object_of_.try_emplace(document_.objects[i].id, i);
  }
  for (std::size_t i = 0; i < document_.constellations.size(); ++i) {
    constellation_of_.try_emplace(document_.constellations[i].id, i);
    for (const Instance& use : document_.constellations[i].instances) inner.insert(use.object);
  }
  for (const Constellation& set : document_.constellations) {
    if (!inner.contains(set.id)) walk({.object = set.id}, {}, {}, 0);
  }
  // What nothing places stands as it is.
  for (std::size_t i = 0; i < document_.objects.size(); ++i) {
    if (!used_.contains(document_.objects[i].id)) show(i, {}, {});
  }
  report();
  return std::move(file_);
}

}  // namespace

MeshFile read_amf(const Source& source) { return AmfReader(source).read(); }

MeshFile read_amf_objects(const std::filesystem::path& path, const RunContext& context) {
  const Source source(path, context);
  MeshFile file{"AMF", {}, {}};
  for (Object& object : amf::parse(source).objects) {
    PolygonSoup all;
    for (Volume& volume : object.volumes) {
      const auto first = static_cast<std::uint32_t>(all.positions.size());
      PolygonSoup& mesh = volume.mesh;
      all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
      for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        all.indices.push_back(first + mesh.indices[i]);
        if (i % 3 == 2) all.offsets.push_back(all.indices.size());
      }
    }
    if (all.polygon_count() > 0) file.objects.push_back(std::move(all));
  }
  return file;
}

}  // namespace burin
