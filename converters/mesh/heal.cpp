#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>

#include <fmt/format.h>

namespace burin {
namespace {

std::string counted(const RecognisedFaces& n) {
  std::string text;
  const auto add = [&](std::int64_t count, const char* one, const char* many) {
    if (count == 0) return;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? one : many);
  };
  add(n.cylinders, "cylinder", "cylinders");
  add(n.cones, "cone", "cones");
  add(n.spheres, "sphere", "spheres");
  add(n.tori, "torus", "tori");
  add(n.revolved, "other surface of revolution", "other surfaces of revolution");
  add(n.swept, "swept surface", "swept surfaces");
  return text;
}

}  // namespace

std::shared_ptr<const Form> recognised(std::shared_ptr<const Form> mesh, const std::string& name,
                                       Diagnostics& diagnostics, const RunContext& context) {
  const auto* form = dynamic_cast<const MeshForm*>(mesh.get());
  if (!form) return mesh;
  auto round =
      std::make_shared<RecognisedForm>(form->mesh(), context, form->texture(), form->faces());
  if (round->too_coarse()) {
    diagnostics.add(Severity::Warning, "mesh.too_coarse_to_heal", 1,
                    fmt::format("{}: so far from the origin, coordinates have too few digits to "
                                "recognise round surfaces; it is drawn as it is, move it nearer",
                                name));
    return mesh;
  }
  if (round->faces().total() == 0) return mesh;
  report_round_faces(round->faces(), name, diagnostics);
  return round;
}

void report_round_faces(const RecognisedFaces& faces, const std::string& name,
                        Diagnostics& diagnostics) {
  if (faces.total() == 0) return;
  diagnostics.add(Severity::Info, "mesh.healed", faces.total(),
                  fmt::format("{}: facets are drawn as the round surfaces they approximate: {}",
                              name, counted(faces)));
}

}  // namespace burin
