#include "surfaces.h"

#include <burin/assembly/items.h>
#include <burin/assembly/select.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace burin::detail {
namespace {

/// Share of a part's size that its triangles may be off.
constexpr double kTolerance = 2e-4;
/// Of both revisions together about a gigabyte.
constexpr std::size_t kMostTriangles = 5'000'000;
/// Share of the chord tolerance that the middle of a curved surface may be off: what the triangles
/// lack on one side they lack on the others.
constexpr double kMiddleError = 0.1;

/// Without " #2", which readers add to what has the name of another part.
std::string as_read(const std::string& name) {
  std::size_t digits = 0;
  while (digits < name.size() && is_digit(name[name.size() - 1 - digits])) ++digits;
  const std::size_t rest = name.size() - digits;
  const bool numbered = digits > 0 && rest > 2 && name.compare(rest - 2, 2, " #") == 0;
  return numbered ? name.substr(0, rest - 2) : name;
}

/// The names of a part from the top; a name that is that of its file is none, so that revisions may
/// be files of different names.
std::vector<std::string> names_of(const Part& part) {
  std::vector<std::string> names = part.assembly;
  names.push_back(part.name);
  const std::filesystem::path file = std::filesystem::path(part.source).filename();
  std::string& first = names.front();
  if (as_read(first) == file.stem().string() || as_read(first) == file.string()) first = ".";
  return names;
}

}  // namespace

Pose pose_of(const ProxyMesh& proxy) {
  const TriMesh& mesh = proxy.mesh;
  Pose s;
  s.box = mesh.bounds();
  if (mesh.triangles.empty()) return s;
  // About a point of the shape: far from the origin nothing is lost.
  const Vec3 about = mesh.positions[mesh.triangles.front()[0]];
  double area = 0;
  Vec3 middle(0);
  const auto each = [&](Vec3 origin, const auto& add) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]] - origin, b = mesh.positions[t[1]] - origin,
                 c = mesh.positions[t[2]] - origin;
      add(a, b, c, 0.5 * glm::length(glm::cross(b - a, c - a)));
    }
  };
  each(about, [&](Vec3 a, Vec3 b, Vec3 c, double piece) {
    area += piece;
    middle += piece / 3 * (a + b + c);
  });
  if (!(area > 0)) {
    s.middle = s.box.center();
    return s;
  }
  middle = about + middle / area;
  s.middle = middle;
  each(middle, [&](Vec3 a, Vec3 b, Vec3 c, double piece) {
    const Vec3 sum = a + b + c;
    for (const Vec3& p : {a, b, c, sum}) s.spread += piece / 12 * glm::outerProduct(p, p);
  });
  s.spread /= area;
  s.error = kMiddleError * proxy.tolerance;
  return s;
}

std::vector<RevisionPart> RevisionSurfaces::measured(double from, double to) {
  std::vector<RevisionPart> parts;
  for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
    context_.check();
    const Part& part = scene_.parts[i];
    RevisionPart& one = parts.emplace_back();
    for (const std::string& name : names_of(part)) {
      const char* between = one.path.empty() ? "" : "/";
      one.path += between + as_read(name);
      one.stem += between + instance_stem(name);
    }
    one.color = lowered(part.color);
    one.drawn = drawn_[i];
    if (const auto surface = this->surface(i)) {
      one.pose = pose_of(surface->proxy());
      one.shape = measure(i);
    }
    if (one.pose.box.empty()) {
      one.pose.box = part.form->bounds(Mat3(1));
      if (!one.pose.box.empty()) one.pose.middle = one.pose.box.center();
    }
    context_.begin_stage(RunStage::Build);
    context_.progress(from + (to - from) * static_cast<double>(i + 1) /
                                 static_cast<double>(scene_.parts.size()));
  }
  return parts;
}

std::shared_ptr<const Surface> RevisionSurfaces::surface(std::size_t part) {
  if (kept_[part]) return kept_[part];
  if (failed_[part]) return nullptr;
  try {
    const Form& form = *scene_.parts[part].form;
    const double size = form.bounds(Mat3(1)).diagonal();
    RealiseOptions options;
    // Facets as they are: rounded ones would be compared by what they are taken for, and cost ten
    // times as much.
    const double share = form.looks_at_view() ? kTolerance : 1;
    options.tolerance = size > 0 ? share * size : share;
    options.curvature = false;
    std::shared_ptr<const Surface> made = form.realise(options, context_);
    const std::size_t count = made->proxy().mesh.triangles.size();
    if (triangles_ + count <= kMostTriangles) {
      triangles_ += count;
      kept_[part] = made;
    }
    return made;
  } catch (const GeometryError& e) {
    failed_[part] = true;
    tell(part, e.what());
    return nullptr;
  }
}

ShapeMeasure RevisionSurfaces::measure(std::size_t part) {
  const Form& form = *scene_.parts[part].form;
  const Definition of = form.definition();
  auto& known = measures_[of.shape];
  const auto same = std::ranges::find_if(known, [&](const auto& m) { return m.first.same(of); });
  if (same != known.end()) return same->second;
  ShapeMeasure made;
  try {
    made = form.measure(context_);
  } catch (const GeometryError& e) {
    tell(part, e.what());
  }
  known.emplace_back(of, made);
  return made;
}

void RevisionSurfaces::tell(std::size_t part, const char* what) {
  diagnostics_.add(Severity::Warning, "diff.not_measured", 1,
                   fmt::format("{}: only its box is compared, as it cannot be measured: {}",
                               path_of(scene_.parts[part]), what));
}

}  // namespace burin::detail
