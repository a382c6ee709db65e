#include "surfaces.h"

#include <burin/assembly/items.h>
#include <burin/assembly/select.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/congruence/body.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace burin::detail {
namespace {

/// Of both revisions together about a gigabyte.
constexpr std::size_t kMostTriangles = 5'000'000;

/// The names of a part from the top; a name that is that of its file is none, so that revisions may
/// be files of different names.
std::vector<std::string> names_of(const Part& part) {
  std::vector<std::string> names = part.assembly;
  names.push_back(part.name);
  const std::filesystem::path file = std::filesystem::path(part.source).filename();
  std::string& first = names.front();
  const std::string_view read = name_as_read(first);
  if (read == model_stem(part.source) || read == file.string()) first = ".";
  return names;
}

/// Where faces of a part have which colour.
std::vector<ColorShare> color_shares(const Part& part, const ProxyMesh& proxy) {
  if (!part.face_colors || proxy.mesh.positions.empty()) return {};
  const TriMesh& mesh = proxy.mesh;
  const Vec3 origin = mesh.positions.front();  // places far from that of the model lose digits
  std::map<std::string, ColorShare> shares;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const std::int32_t color = part.face_colors->at(proxy.face_source(f));
    ColorShare& share =
        shares[color < 0 ? "" : lowered(part.face_colors->colors[static_cast<std::size_t>(color)])];
    const double area = mesh.area(f);
    Vec3 sum(0), squares(0);
    for (const std::uint32_t v : mesh.triangles[f]) {
      const Vec3 p = mesh.positions[v] - origin;
      sum += p;
      squares += p * p;
    }
    share.area += area;
    share.middle += area / 3 * sum;
    share.spread += area / 12 * (sum * sum + squares);
  }
  std::vector<ColorShare> out;
  for (auto& [color, share] : shares) {
    if (!(share.area > 0)) continue;
    share.color = color;
    share.middle /= share.area;
    share.spread = share.spread / share.area - share.middle * share.middle;
    share.middle += origin;
    out.push_back(std::move(share));
  }
  return out;
}

}  // namespace

std::vector<RevisionPart> RevisionSurfaces::measured(double from, double to) {
  std::vector<RevisionPart> parts;
  for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
    context_.check();
    const Part& part = scene_.parts[i];
    RevisionPart& one = parts.emplace_back();
    for (const std::string& name : names_of(part)) {
      const char* between = one.path.empty() ? "" : "/";
      one.path.append(between).append(name_as_read(name));
      one.stem += between + instance_stem(name);
    }
    one.color = lowered(part.color);
    one.opacity = part.opacity;
    one.drawn = drawn_[i];
    if (const auto surface = this->surface(i)) {
      one.pose = pose_of(surface->proxy().mesh, surface->proxy().tolerance);
      one.shape = measure(i);
      one.face_colors = color_shares(part, surface->proxy());
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
    std::shared_ptr<const Surface> made = realised_to_compare(*scene_.parts[part].form, context_);
    const std::size_t count = made->proxy().mesh.triangles.size();
    if (triangles_ + count <= kMostTriangles) {
      triangles_ += count;
      kept_[part] = made;
    }
    return made;
  } catch (const GeometryError& e) {
    failed_[part] = true;
    report(part, e.what());
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
    report(part, e.what());
  }
  known.emplace_back(of, made);
  return made;
}

void RevisionSurfaces::report(std::size_t part, const char* what) {
  diagnostics_.add(Severity::Warning, "diff.not_measured", 1,
                   fmt::format("{}: only its box is compared, as it cannot be measured: {}",
                               path_of(scene_.parts[part]), what));
}

}  // namespace burin::detail
