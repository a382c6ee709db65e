#include "iges_names.h"

#include <IGESBasic_Name.hxx>
#include <IGESBasic_SingularSubfigure.hxx>
#include <IGESBasic_SubfigureDef.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <array>

namespace burin {
namespace {

bool is_member(int type) {
  // Solid, group, instance of a subfigure, instance of a solid.
  constexpr std::array kTypes{186, 402, 408, 430};
  return std::ranges::count(kTypes, type) > 0;
}

/// That of its property, else that of the subfigure it is an instance of. Labels of entities say
/// nothing: programs number these.
std::string name_of(const Handle(IGESData_IGESEntity) & entity) {
  const auto text = [](const Handle(TCollection_HAsciiString) & string) {
    return string.IsNull() ? std::string() : std::string(string->ToCString());
  };
  const Handle(Standard_Type) kind = STANDARD_TYPE(IGESBasic_Name);
  if (entity->NbTypedProperties(kind) > 0) {
    // Of several the first counts; asked for without a number OCCT throws where there are two.
    return text(Handle(IGESBasic_Name)::DownCast(entity->TypedProperty(kind, 1))->Value());
  }
  const auto instance = Handle(IGESBasic_SingularSubfigure)::DownCast(entity);
  if (instance.IsNull() || instance->Subfigure().IsNull()) return {};
  return text(instance->Subfigure()->Name());
}

}  // namespace

std::vector<std::pair<TopoDS_Shape, std::string>> named_members(IGESCAFControl_Reader& reader) {
  std::vector<std::pair<TopoDS_Shape, std::string>> named;
  const Handle(Transfer_TransientProcess) process =
      reader.WS()->TransferReader()->TransientProcess();
  const Handle(IGESData_IGESModel) model = reader.IGESModel();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(IGESData_IGESEntity) entity = model->Entity(i);
    if (!is_member(entity->TypeNumber())) continue;
    std::string name = name_of(entity);
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (!name.empty() && !shape.IsNull()) named.emplace_back(shape, std::move(name));
  }
  return named;
}

}  // namespace burin
