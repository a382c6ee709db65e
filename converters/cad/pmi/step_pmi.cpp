#include "step_pmi.h"

#include "step_measure.h"
#include "step_presentation.h"
#include "step_semantics.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr std::array<std::string_view, 4> kAnnotations{
    "TESSELLATED_ANNOTATION_OCCURRENCE", "ANNOTATION_CURVE_OCCURRENCE",
    "ANNOTATION_FILL_AREA_OCCURRENCE", "ANNOTATION_OCCURRENCE"};

/// A model of annotations: what it holds, and how.
struct Model {
  std::vector<std::int64_t> items;
  StepUnit unit{StepUnit::Kind::Length, 1};
};

class Reader {
 public:
  explicit Reader(const StepText& text)
      : text_(text),
        semantics_(text),
        frames_(links_of(text, {"GEOMETRIC_TOLERANCE_RELATIONSHIP"}, 3, 2)) {
    link_callouts();
    find_models();
    find_planes();
  }

  StepPmi run() {
    for (const std::int64_t number : semantics_.all()) add_stated(number);
    for (const std::int64_t callout : callouts()) {
      if (!used_.contains(callout)) add_shown(callout);
    }
    for (StepPmiItem& item : pmi_.items) name_views(item);
    return std::move(pmi_);
  }

 private:
  /// A callout is linked to what it is about, and, by a link of a name, to what it states.
  void link_callouts() {
    for (const std::string_view type : {"DRAUGHTING_MODEL_ITEM_ASSOCIATION",
                                        "DRAUGHTING_MODEL_ITEM_ASSOCIATION_WITH_PLACEHOLDER"}) {
      for (const std::int64_t number : text_.of_type(type)) {
        const StepEntity entity = text_.entity(number);
        const StepRecord* record = entity.as(type);
        if (record == nullptr) continue;
        const bool states = record->at(0).text == "PMI representation to presentation link";
        for (const std::int64_t callout : record->at(4).references()) {
          for (const std::int64_t meant : record->at(2).references()) {
            meanings_[callout].push_back(meant);
            if (states) statements_[callout].push_back(meant);
          }
        }
      }
    }
    for (const auto& [callout, meant] : meanings_) statements_.try_emplace(callout, meant);
  }

  void find_models() {
    std::vector<std::int64_t> numbers = text_.of_type("DRAUGHTING_MODEL");
    for (const std::int64_t number : numbers) {
      const StepEntity entity = text_.entity(number);
      const StepRecord* record = entity.as_one_of({"REPRESENTATION", "DRAUGHTING_MODEL"});
      if (record == nullptr) continue;
      Model model{record->at(1).references(), length_unit_of_context(text_, record->at(2).entity)};
      for (const std::int64_t item : model.items) {
        const StepEntity one = text_.entity(item);
        if (const StepRecord* camera =
                one.as_one_of({"CAMERA_MODEL_D3", "CAMERA_MODEL_D3_MULTI_CLIPPING",
                               "CAMERA_MODEL_D3_WITH_HLHSR"})) {
          add_view(*camera, model);
        }
      }
      for (const std::int64_t item : model.items) units_.emplace(item, model.unit);
    }
  }

  /// The file's z of a view looks into the picture, its y is up.
  void add_view(const StepRecord& camera, const Model& model) {
    const StepAxes axes = axes_of(text_, camera.at(1).entity);
    const std::string& name = camera.at(0).text;
    for (const std::int64_t item : model.items) shows_[item].push_back(name);
    if (std::ranges::find(pmi_.views, name, &PmiView::name) == pmi_.views.end()) {
      // No zeros with a sign.
      pmi_.views.push_back({name, Vec3(0) - axes.z, axes.y});
    }
  }

  void find_planes() {
    for (const std::int64_t number : text_.of_type("ANNOTATION_PLANE")) {
      const StepEntity entity = text_.entity(number);
      const StepRecord* record = entity.as("ANNOTATION_PLANE");
      if (record == nullptr) continue;
      const StepEntity plane = text_.entity(record->at(2).entity);
      const StepRecord* of = plane.as("PLANE");
      const StepAxes axes = axes_of(text_, of != nullptr ? of->at(1).entity : record->at(2).entity);
      for (const std::int64_t one : record->at(3).references()) {
        planes_.emplace(one, axes);
        // What a view shows may be the plane alone.
        for (const std::string& view : shows_[number]) shows_[one].push_back(view);
        if (const auto unit = units_.find(number); unit != units_.end()) {
          units_.emplace(one, unit->second);
        }
      }
    }
  }

  /// Callouts, and annotations outside of them that a view shows.
  std::vector<std::int64_t> callouts() const {
    std::vector<std::int64_t> all = text_.of_type("DRAUGHTING_CALLOUT");
    std::set<std::int64_t> inside;
    for (const std::int64_t number : all) {
      const StepEntity entity = text_.entity(number);
      const StepRecord* record = entity.as("DRAUGHTING_CALLOUT");
      if (record == nullptr) continue;
      for (const std::int64_t one : record->at(record->values.size() - 1).references()) {
        inside.insert(one);
      }
    }
    for (const std::string_view type : kAnnotations) {
      for (const std::int64_t number : text_.of_type(type)) {
        if (!inside.contains(number)) all.push_back(number);
      }
    }
    return all;
  }

  /// The callouts that show what an entity states.
  std::vector<std::int64_t> callouts_of(std::int64_t number) const {
    std::vector<std::int64_t> all;
    for (const auto& [callout, meant] : statements_) {
      if (std::ranges::find(meant, number) != meant.end()) all.push_back(callout);
    }
    return all;
  }

  void add_stated(std::int64_t number) {
    std::optional<StepPmiItem> item = semantics_.item(number);
    if (!item) return;
    for (const std::int64_t callout : callouts_of(number)) {
      item->item.name = name_of(callout, item->item.name);
      callouts_[pmi_.items.size()].push_back(callout);
      if (used_.contains(callout)) {
        item->item.shown_with = static_cast<std::int32_t>(used_.at(callout));
        continue;
      }
      used_.emplace(callout, pmi_.items.size());
      show(callout, *item);
      add_notes(callout, item->item);
    }
    share_frame(number, item->item);
    pmi_.items.push_back(*std::move(item));
  }

  /// Of several tolerances in one frame the file may link the first alone to it.
  void share_frame(std::int64_t number, PmiItem& item) {
    if (item.shown() || item.shown_with >= 0) return;
    const auto first = frames_.find(number);
    if (first == frames_.end()) return;
    const auto found = std::ranges::find(pmi_.items, first->second.front(), &StepPmiItem::entity);
    if (found == pmi_.items.end()) return;
    const auto at = static_cast<std::size_t>(found - pmi_.items.begin());
    item.shown_with = static_cast<std::int32_t>(at);
    callouts_[pmi_.items.size()] = callouts_[at];
  }

  /// What a callout says in words beside what it states.
  void add_notes(std::int64_t callout, PmiItem& item) const {
    if (item.kind != PmiKind::Dimension && item.kind != PmiKind::Tolerance) return;
    for (const std::int64_t meant : statements_.at(callout)) {
      const auto note = semantics_.item(meant);
      if (note && note->item.kind == PmiKind::Note && !note->item.text.empty()) {
        item.text += ", " + note->item.text;
      }
    }
  }

  /// A callout that states nothing which is understood: a note, or what it is called.
  void add_shown(std::int64_t callout) {
    StepPmiItem item;
    if (const auto meant = meanings_.find(callout); meant != meanings_.end()) {
      for (const std::int64_t number : meant->second) {
        if (auto note = semantics_.item(number); note && note->item.kind == PmiKind::Note) {
          item = *std::move(note);
        } else if (item.entity == 0) {
          const auto faces = semantics_.aspects().faces_of(number);
          item.faces.insert(item.faces.end(), faces.begin(), faces.end());
          if (item.product == 0) item.product = semantics_.aspects().product_of(number);
        }
      }
    }
    item.item.name = name_of(callout, item.item.name);
    if (item.item.kind == PmiKind::Other) item.item.what = item.item.name;
    if (item.item.text.empty()) item.item.text = item.item.name;
    show(callout, item);
    callouts_[pmi_.items.size()].push_back(callout);
    used_.emplace(callout, pmi_.items.size());
    if (item.item.kind == PmiKind::Other && !item.item.shown()) return;
    pmi_.items.push_back(std::move(item));
  }

  std::string name_of(std::int64_t callout, const std::string& fallback) const {
    const StepEntity entity = text_.entity(callout);
    for (const StepRecord& record : entity.records) {
      if (!record.at(0).text.empty() && record.at(0).kind == StepValue::Kind::Text) {
        return record.at(0).text;
      }
    }
    return fallback;
  }

  void show(std::int64_t callout, StepPmiItem& item) {
    StepShown shown = StepPresentation(text_, pmi_.unknown).of(callout);
    const auto unit = units_.find(callout);
    const double mm = unit == units_.end() ? 1 : unit->second.factor;
    for (auto* lines : {&shown.lines, &shown.filled}) {
      for (PmiLine& line : *lines) {
        for (Vec3& point : line.points) point *= mm;
      }
    }
    if (const auto plane = planes_.find(callout); plane != planes_.end()) {
      shown.plane = plane->second;
    }
    if (shown.plane) {
      item.item.plane = {mm * shown.plane->origin, shown.plane->z, shown.plane->x};
    }
    std::ranges::move(shown.lines, std::back_inserter(item.item.lines));
    std::ranges::move(shown.filled, std::back_inserter(item.item.filled));
  }

  void name_views(StepPmiItem& item) {
    const auto i = static_cast<std::size_t>(&item - pmi_.items.data());
    for (const std::int64_t callout : callouts_[i]) {
      for (const std::string& view : shows_[callout]) {
        if (std::ranges::find(item.item.views, view) == item.item.views.end()) {
          item.item.views.push_back(view);
        }
      }
    }
  }

  const StepText& text_;
  StepSemantics semantics_;
  /// From callouts to what they are about, and to what they state.
  StepLinks meanings_, statements_;
  /// From tolerances to those that they refine.
  StepLinks frames_;
  std::map<std::int64_t, StepUnit> units_;
  std::map<std::int64_t, StepAxes> planes_;
  /// The views that show a callout; the callouts of items; the item that a callout is shown with.
  std::map<std::int64_t, std::vector<std::string>> shows_;
  std::map<std::size_t, std::vector<std::int64_t>> callouts_;
  std::map<std::int64_t, std::size_t> used_;
  StepPmi pmi_;
};

}  // namespace

StepPmi read_step_pmi(const StepText& text) { return Reader(text).run(); }

}  // namespace burin
