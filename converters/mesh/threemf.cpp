#include "formats.h"
#include "package.h"
#include "text.h"
#include "threemf_model.h"

#include <fmt/format.h>

#include <map>

namespace burin {
namespace {

constexpr std::size_t kDeepest = 64;        // components inside components
constexpr std::size_t kMostUses = 100'000;  // a few lines of components can ask for 2^60 objects
constexpr std::size_t kMostTriangles = 100'000'000;

class ThreeMfReader {
 public:
  explicit ThreeMfReader(const Source& source) : source_(source), package_(source, "3MF archive") {}
  MeshFile read();

 private:
  std::string root_path() const;
  const ThreeMfModel& model(const std::string& path);
  void place(const ThreeMfUse& use, const std::string& path, const ThreeMfTransform& outer,
             const std::string& outer_name, std::size_t depth);
  void emit(const ThreeMfObject& object, const ThreeMfTransform& transform, double unit,
            const std::string& name);

  const Source& source_;
  Package package_;
  std::map<std::string, ThreeMfModel> models_;
  std::size_t uses_ = 0, triangles_ = 0;
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

void ThreeMfReader::emit(const ThreeMfObject& object, const ThreeMfTransform& transform,
                         double unit, const std::string& name) {
  triangles_ += object.mesh.polygon_count();
  if (triangles_ > kMostTriangles) {
    source_.fail(
        fmt::format("the components of the 3MF ask for more than {} triangles; it is damaged or "
                    "hostile",
                    kMostTriangles));
  }
  PolygonSoup soup = object.mesh;
  soup.name = name;
  for (Vec3& p : soup.positions) p = unit * transform.apply(p);
  if (transform.mirrors()) {  // keep the triangles counter-clockwise
    for (std::size_t i = 0; i + 2 < soup.indices.size(); i += 3) {
      std::swap(soup.indices[i + 1], soup.indices[i + 2]);
      if (!soup.texture.empty()) std::swap(soup.texture[i + 1], soup.texture[i + 2]);
    }
  }
  file_.objects.push_back(std::move(soup));
}

void ThreeMfReader::place(const ThreeMfUse& use, const std::string& path,
                          const ThreeMfTransform& outer, const std::string& outer_name,
                          std::size_t depth) {
  source_.context().check();
  if (depth > kDeepest || ++uses_ > kMostUses) {
    source_.fail(
        "the components of the 3MF contain each other or are far too many; it is damaged or "
        "hostile");
  }
  const std::string& where = use.path.empty() ? path : use.path;
  const ThreeMfModel& in = model(where);
  const auto found = in.objects.find(use.object);
  if (found == in.objects.end()) {
    source_.fail(fmt::format("{} has no object {}, which is used; export it again", where,
                             in_quotes(use.object)));
  }
  const ThreeMfObject& object = found->second;
  const std::string& name = object.name.empty() ? outer_name : object.name;
  const ThreeMfTransform transform = use.transform.then(outer);
  if (object.mesh.polygon_count() > 0) emit(object, transform, in.unit, name);
  for (const ThreeMfUse& c : object.components) place(c, where, transform, name, depth + 1);
}

MeshFile ThreeMfReader::read() {
  file_.format = "3MF";
  const std::string path = root_path();
  const ThreeMfModel& root = model(path);
  if (root.build.empty()) {
    for (const std::string& id : root.order) {
      const ThreeMfObject& object = root.objects.at(id);
      if (object.mesh.polygon_count() > 0) emit(object, {}, root.unit, object.name);
    }
    if (!file_.objects.empty()) {
      file_.diagnostics.add(Severity::Info, "3mf.no_build", 1,
                            "the 3MF builds nothing; all of its objects are shown");
    }
  }
  for (const ThreeMfUse& item : root.build) place(item, path, {}, {}, 0);
  if (file_.objects.empty()) source_.fail("the 3MF holds no triangles; export it again");
  return std::move(file_);
}

}  // namespace

MeshFile read_3mf(const Source& source) { return ThreeMfReader(source).read(); }

}  // namespace burin
