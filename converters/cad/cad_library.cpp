#include "cad_library.h"

#include <burin/base/error.h>
#include <burin/base/version.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>

#include "cad_file.h"
#include "measure.h"
#include "occt_session.h"
#include "shape_in_memory.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

namespace burin {
namespace {

/// The models of shapes, each made once.
class Models {
 public:
  /// The number of the model and the model; throws GeometryError.
  std::pair<std::size_t, std::shared_ptr<const BrepModel>> of(const TopoDS_Shape& shape) {
    const auto key = std::pair(shape.TShape().get(), shape.Orientation());
    const auto it = known_.find(key);
    if (it != known_.end()) return it->second;
    return known_[key] = {known_.size(), make_brep_model(shape)};
  }

 private:
  std::map<std::pair<TopoDS_TShape*, TopAbs_Orientation>,
           std::pair<std::size_t, std::shared_ptr<const BrepModel>>>
      known_;
};

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

Scene read(const std::filesystem::path& path, RunContext& context) {
  const OcctSession session;
  CadFile file = read_cad_file(path, session, context);
  Scene scene;
  scene.diagnostics = std::move(file.diagnostics);
  Models models;
  for_parts(file, session, path.string(), scene.diagnostics, context, [&](CadPart& part) {
    auto form = std::make_shared<BrepForm>(models.of(part.shape).second, part.placement);
    scene.parts.push_back({std::move(part.name), path.string(), std::move(form),
                           std::move(part.assembly), std::move(part.color),
                           std::move(part.definition)});
  });
  return scene;
}

FileInfo inspect(const std::filesystem::path& path, RunContext& context) {
  const OcctSession session;
  CadFile file = read_cad_file(path, session, context);
  FileInfo info;
  info.file = path.string();
  info.format = std::move(file.format);
  info.schema = std::move(file.schema);
  info.diagnostics = std::move(file.diagnostics);
  Models models;
  std::map<std::size_t, std::int32_t> first;  // part of each model
  for_parts(file, session, info.file, info.diagnostics, context, [&](CadPart& part) {
    const auto [number, model] = models.of(part.shape);
    PartInfo p = measure(*model, part.placement);
    const auto [it, is_new] =
        first.try_emplace(number, static_cast<std::int32_t>(info.parts.size()));
    if (!is_new) p.same_shape_as = it->second;
    p.name = std::move(part.name);
    p.assembly = std::move(part.assembly);
    p.color = std::move(part.color);
    info.parts.push_back(std::move(p));
  });
  return info;
}

constexpr CadLibrary kLibrary{
    BURIN_CAD_VERSION,      read, inspect, read_text_in_memory, read_shape_in_memory,
    trimmed_faces_in_memory};

}  // namespace
}  // namespace burin

extern "C" const burin::CadLibrary* burin_cad_library() { return &burin::kLibrary; }
