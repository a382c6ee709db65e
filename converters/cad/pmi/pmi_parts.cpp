#include "pmi_parts.h"

#include "step_aspects.h"

#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace burin {
namespace {

/// A face of what some parts share.
struct FacePlace {
  std::size_t shape = 0;
  std::int32_t face = 0;
};

/// The faces of parts, by what OCCT has of them.
class PartFaces {
 public:
  explicit PartFaces(const std::vector<CadPart>& parts) {
    for (const CadPart& part : parts) {
      const auto [at, is_new] = shapes_.try_emplace(part.bodies.get(), shapes_.size());
      if (!is_new) continue;
      std::int32_t first = 0;
      for (const CadBody& body : *part.bodies) {
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(body.shape, TopAbs_FACE, faces);
        for (int i = 1; i <= faces.Extent(); ++i) {
          faces_.try_emplace(faces(i).TShape().get(), FacePlace{at->second, first + i - 1});
        }
        first += faces.Extent();
      }
    }
  }

  std::optional<FacePlace> find(const TopoDS_Shape& face) const {
    const auto found = faces_.find(face.TShape().get());
    if (face.IsNull() || found == faces_.end()) return std::nullopt;
    return found->second;
  }
  std::size_t shape_of(const CadPart& part) const { return shapes_.at(part.bodies.get()); }
  std::size_t count() const { return shapes_.size(); }

 private:
  /// What parts share, numbered in the order of the parts.
  std::map<const void*, std::size_t> shapes_;
  std::map<const void*, FacePlace> faces_;
};

/// Where the faces are that items name, by their entities.
std::map<std::int64_t, FacePlace> places_of(const StepPmi& pmi, STEPCAFControl_Reader& reader,
                                            const PartFaces& faces) {
  std::set<std::int64_t> wanted;
  for (const StepPmiItem& item : pmi.items) wanted.insert(item.faces.begin(), item.faces.end());
  std::map<std::int64_t, FacePlace> places;
  const Handle(Transfer_TransientProcess) process =
      reader.Reader().WS()->TransferReader()->TransientProcess();
  const Handle(StepData_StepModel) model = reader.ChangeReader().StepModel();
  for (int i = 1; i <= model->NbEntities() && !process.IsNull() && !wanted.empty(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const std::int64_t number = model->IdentLabel(entity);
    if (!wanted.contains(number)) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (shape.IsNull()) continue;
    if (const auto place = faces.find(shape)) places.emplace(number, *place);
  }
  return places;
}

/// The shape that an item is about, and the faces of it.
std::optional<std::size_t> put_faces(StepPmiItem& item,
                                     const std::map<std::int64_t, FacePlace>& places) {
  std::optional<std::size_t> shape;
  for (const std::int64_t number : item.faces) {
    const auto place = places.find(number);
    if (place == places.end()) continue;
    if (!shape) shape = place->second.shape;
    if (place->second.shape == *shape) item.item.faces.push_back(place->second.face);
  }
  make_set(item.item.faces);
  return shape;
}

void report(const StepPmi& pmi, std::int64_t lost, Diagnostics& diagnostics) {
  if (lost > 0) {
    diagnostics.add(Severity::Warning, "pmi.no_part", lost,
                    "dimensions, tolerances or notes belong to no part that has faces, such as "
                    "those of an assembly, and were left out");
  }
  if (pmi.unknown.empty()) return;
  std::string names;
  std::int64_t count = 0;
  for (const auto& [type, n] : pmi.unknown) {
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", type, n);
    count += n;
  }
  diagnostics.add(Severity::Warning, "pmi.not_understood", count,
                  "what these entities show of dimensions and notes was left out: " + names);
}

}  // namespace

bool may_have_pmi(std::string_view text) {
  constexpr std::array<std::string_view, 4> kWords{"DRAUGHTING_CALLOUT", "_TOLERANCE", "DATUM",
                                                   "DIMENSIONAL_"};
  return std::ranges::any_of(
      kWords, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

void give_pmi(StepPmi pmi, STEPCAFControl_Reader& reader, std::vector<CadPart>& parts,
              Diagnostics& diagnostics) {
  if (pmi.items.empty()) return report(pmi, 0, diagnostics);
  const PartFaces faces(parts);
  const auto places = places_of(pmi, reader, faces);
  std::vector<std::optional<std::size_t>> shapes;
  std::map<std::int64_t, std::size_t> products;
  for (StepPmiItem& item : pmi.items) {
    shapes.push_back(put_faces(item, places));
    if (shapes.back() && item.product != 0) products.try_emplace(item.product, *shapes.back());
  }
  std::vector<std::shared_ptr<Pmi>> made(faces.count());
  std::vector<std::int32_t> number(pmi.items.size(), -1);
  std::int64_t lost = 0;
  for (std::size_t i = 0; i < pmi.items.size(); ++i) {
    StepPmiItem& item = pmi.items[i];
    std::optional<std::size_t> shape = shapes[i];
    if (!shape && faces.count() == 1) shape = 0;
    if (const auto of = products.find(item.product); !shape && of != products.end()) {
      shape = of->second;
    }
    if (!shape) {
      ++lost;
      continue;
    }
    std::shared_ptr<Pmi>& to = made[*shape];
    if (!to) to = std::make_shared<Pmi>(Pmi{{}, pmi.views});
    const std::int32_t with = item.item.shown_with;
    if (with >= 0) item.item.shown_with = number[static_cast<std::size_t>(with)];
    number[i] = static_cast<std::int32_t>(to->items.size());
    to->items.push_back(std::move(item.item));
  }
  for (CadPart& part : parts) part.pmi = made[faces.shape_of(part)];
  report(pmi, lost, diagnostics);
}

}  // namespace burin
