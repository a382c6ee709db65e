// Surfaces of volumes.
#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/volume_reader.h>
#include <burin/forms/implicit/implicit_form.h>

#include "text.h"
#include "triangles_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace burin {
namespace {

void check_level(const VolumeInfo& info, const std::optional<double>& level,
                 const std::string& file) {
  const std::string values = info.min == info.max
                                 ? fmt::format("{:.6g} alone", info.min)
                                 : fmt::format("{:.6g} to {:.6g}", info.min, info.max);
  if (info.min == info.max) {
    throw InputError(fmt::format("has values of {}; no level makes a surface", values), file);
  }
  if (!level) {
    throw InputError(fmt::format("has values of {}; give the level of the surface to draw, e.g. "
                                 "`iso {:.6g}`",
                                 values, info.level),
                     file);
  }
  if (!(*level > info.min && *level < info.max)) {
    throw InputError(fmt::format("the level {:.6g} is outside the values of the data, {}; try "
                                 "`iso {:.6g}`",
                                 *level, values, info.level),
                     file);
  }
}

// The part of the domain that holds samples; none where the two are apart.
std::optional<Box3> common(const std::optional<Box3>& domain, const Box3& of_samples,
                           const std::string& file) {
  if (!domain) return {};
  const Box3 box{glm::max(domain->min, of_samples.min), glm::min(domain->max, of_samples.max)};
  for (int k = 0; k < 3; ++k) {
    if (box.min[k] < box.max[k]) continue;
    throw InputError("lies outside the given bounds; burin info lists its own", file);
  }
  return box;
}

Scene scene_of(Volume volume, const std::filesystem::path& path, const VolumeReadOptions& options,
               const std::optional<Box3>& bounds, const RunContext& context) {
  const std::string file = path.string();
  check_level(volume.info, options.level, file);
  const std::optional<Box3> domain = common(bounds, volume.info.bounds, file);
  Scene scene;
  scene.diagnostics = std::move(volume.diagnostics);
  try {
    auto function = make_volume_function(std::move(volume.grid),
                                         {*options.level, options.inside_above.value_or(true),
                                          options.degree, options.interpolate, options.smoothing},
                                         context);
    auto form =
        std::make_shared<ImplicitForm>(std::move(function), domain, context, options.smallest_part,
                                       ImplicitProxyOptions{options.mesher});
    scene.parts.push_back({clean_name(model_stem(path)), file, std::move(form)});
  } catch (const GeometryError& e) {
    throw InputError(e.what(), file);
  } catch (const UsageError& e) {
    throw InputError(e.what(), file);
  }
  return scene;
}

void measure(const Part& part, FileInfo& info, RunContext& context) {
  constexpr double kChord = 1e-3;  // of the size: half a sample of a common volume
  PartInfo out;
  out.name = part.name;
  out.bounds = part.form->bounds(Mat3(1));
  RealiseOptions realise;
  realise.tolerance = kChord * out.bounds.diagonal();
  realise.curvature = false;
  realise.diagnostics = &info.diagnostics;
  const auto surface = part.form->realise(realise, context);
  const ProxyMesh& proxy = surface->proxy();
  out.components = static_cast<std::int64_t>(proxy.topology.component_closed.size());
  out.faces = proxy.region_count;
  measure_triangles(proxy.mesh, out);
  info.parts.push_back(std::move(out));
}

}  // namespace

Scene read_volume_scene(const std::filesystem::path& path, const VolumeReadOptions& options,
                        const std::optional<Box3>& bounds, RunContext& context) {
  return scene_of(read_volume(path, options, context), path, options, bounds, context);
}

FileInfo inspect_volume(const std::filesystem::path& path, const VolumeReadOptions& options,
                        const std::optional<Box3>& bounds, RunContext& context) {
  Volume volume = read_volume(path, options, context);
  FileInfo info;
  info.file = path.string();
  info.format = volume.format;
  info.volume = volume.info;
  info.diagnostics = volume.diagnostics;
  if (!options.level) return info;
  const Scene scene = scene_of(std::move(volume), path, options, bounds, context);
  for (const Part& part : scene.parts) measure(part, info, context);
  return info;
}

}  // namespace burin
