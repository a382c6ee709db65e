#include "tessellated.h"

#include <Interface_ParamType.hxx>
#include <Interface_UndefinedContent.hxx>
#include <Standard_Version.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace burin {
namespace {

constexpr std::array<std::string_view, 6> kFaces{"TRIANGULATED_FACE",
                                                 "COMPLEX_TRIANGULATED_FACE",
                                                 "CUBIC_BEZIER_TRIANGULATED_FACE",
                                                 "TRIANGULATED_SURFACE_SET",
                                                 "COMPLEX_TRIANGULATED_SURFACE_SET",
                                                 "CUBIC_BEZIER_TRIANGULATED_SURFACE_SET"};
constexpr std::array<std::string_view, 3> kBodies{"TESSELLATED_SOLID", "TESSELLATED_SHELL",
                                                  "TESSELLATED_CLOSED_SHELL"};

/// Whether its last parameter, the exact body that it stands for, is left open.
bool without_link(const StepData_UndefinedEntity& body) {
  const Handle(Interface_UndefinedContent) content = body.UndefinedContent();
  const int n = content.IsNull() ? 0 : content->NbParams();
  return n == 0 || content->ParamType(n) == Interface_ParamVoid;
}

}  // namespace

Tessellated::Tessellated(const StepData_StepModel& model) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    auto entity = Handle(StepData_UndefinedEntity)::DownCast(model.Value(i));
    // One of several types is a chain.
    for (; !entity.IsNull(); entity = entity->Next()) {
      const std::string_view type = entity->StepType();
      if (std::ranges::find(kFaces, type) != kFaces.end()) ++faces_;
      if (std::ranges::find(kBodies, type) == kBodies.end()) continue;
      ++bodies_;
      if (without_link(*entity)) ++alone_;
    }
  }
}

void Tessellated::report(CadFile& file, const Source& source) const {
  if (file.parts.empty() && faces_ + bodies_ > 0) {
    source.fail(fmt::format(
        "holds tessellated geometry only (triangles of AP242: {} bodies, {} faces), which OCCT {} "
        "does not read; export it as boundary representation, or as STL, 3MF or OBJ",
        bodies_, faces_, OCC_VERSION_COMPLETE));
  }
  if (alone_ == 0) return;
  file.diagnostics.add(Severity::Warning, "step.tessellated", alone_,
                       "tessellated solids or shells (triangles of AP242) were left out; export "
                       "them as boundary representation");
}

}  // namespace burin
