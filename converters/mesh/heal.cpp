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
    const RecognisedFaces faces = healed->faces();
    if (faces.total() == 0) continue;
    scene.diagnostics.add(Severity::Info, "mesh.healed", faces.total(),
                          fmt::format("{}: facets are drawn as the round surfaces that they stand "
                                      "for: {}",
                                      part.name, told(faces)));
    part.form = std::move(healed);
  }
}

}  // namespace burin
