#include "step_names.h"

#include "text.h"

#include <STEPCAFControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace burin {
namespace {

std::string text(const Handle(TCollection_HAsciiString) & string) {
  return string.IsNull() ? std::string() : clean_name(string->ToCString());
}

}  // namespace

std::multimap<std::string, std::string> numbers_of_products(STEPCAFControl_Reader& reader) {
  std::multimap<std::string, std::string> numbers;
  const Handle(StepData_StepModel) model = reader.ChangeReader().StepModel();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (product.IsNull()) continue;
    const std::string name = text(product->Name()), number = text(product->Id());
    if (!name.empty() && !number.empty() && name != number) numbers.emplace(name, number);
  }
  return numbers;
}

ShapeNames names_of_solids(STEPCAFControl_Reader& reader) {
  ShapeNames names;
  const Handle(Transfer_TransientProcess) process =
      reader.Reader().WS()->TransferReader()->TransientProcess();
  const Handle(StepData_StepModel) model = reader.ChangeReader().StepModel();
  for (int i = 1; i <= model->NbEntities() && !process.IsNull(); ++i) {
    const auto solid = Handle(StepShape_SolidModel)::DownCast(model->Value(i));
    if (solid.IsNull()) continue;
    const std::string name = text(solid->Name());
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, solid);
    if (name.empty() || shape.IsNull()) continue;
    names.Bind(shape.Located(TopLoc_Location()), name);
  }
  return names;
}

}  // namespace burin
