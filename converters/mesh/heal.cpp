#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>

#include <fmt/format.h>

namespace burin {
namespace {

std::string told(const RecognisedFaces& n) {
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
  return text;
}

}  // namespace

void heal_parts(Scene& scene, const RunContext& context) {
  for (Part& part : scene.parts) {
    const auto* form = dynamic_cast<const MeshForm*>(part.form.get());
    if (!form) continue;
    auto healed = std::make_shared<RecognisedForm>(form->mesh(), context, form->texture());
    if (healed->too_coarse()) {
      scene.diagnostics.add(Severity::Warning, "mesh.too_coarse_to_heal", 1,
                            fmt::format("{}: so far from the origin its coordinates have too few "
                                        "digits to tell round from flat; it is drawn as it is, "
                                        "move it nearer",
                                        part.name));
      continue;
    }
    if (healed->faces().total() == 0) continue;
    tell_round_faces(healed->faces(), part.name, scene.diagnostics);
    part.form = std::move(healed);
  }
}

void tell_round_faces(const RecognisedFaces& faces, const std::string& name,
                      Diagnostics& diagnostics) {
  if (faces.total() == 0) return;
  diagnostics.add(Severity::Info, "mesh.healed", faces.total(),
                  fmt::format("{}: facets are drawn as the round surfaces that they stand for: {}",
                              name, told(faces)));
}

}  // namespace burin
