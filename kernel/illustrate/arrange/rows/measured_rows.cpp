#include "measured_rows.h"

#include <burin/arrange/arrange.h>
#include <burin/assembly/items.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/measure/measure.h>

#include "realised_forms.h"
#include "through_hole.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace burin {

const char* to_string(DimensionRow::Kind kind) {
  constexpr std::array<const char*, 7> kNames{"distance", "diameter", "radius", "angle",
                                              "depth",    "thread",   "note"};
  return kNames[static_cast<std::size_t>(kind)];
}

const std::vector<std::string>& note_values() {
  static const std::vector<std::string> names{"part.name", "item",   "length", "area",
                                              "diameter",  "radius", "volume"};
  return names;
}

namespace detail {
namespace {

using Kind = DimensionRow::Kind;

/// Of the diagonal of what is drawn: how far a point may lie from the feature that it names.
constexpr double kNear = 1e-2;

/// A feature that is not found again.
class LostPlace : public UsageError {
 public:
  using UsageError::UsageError;
};

/// A hole that has no depth.
class NoDepth : public UsageError {
 public:
  using UsageError::UsageError;
};

/// The parts that are drawn, realised when they are asked for.
class Measurer {
 public:
  Measurer(Scene& scene, const Illustration& illustration, RunContext& context)
      : scene_(scene),
        drawn_(drawn_parts(scene, illustration.illustrate.part_styles)),
        diagonal_(drawn_bounds(scene, illustration.illustrate.part_styles).diagonal()),
        context_(context),
        forms_(diagonal_, context) {}

  MeasuredRow measured(const DimensionRow& row, std::size_t number) {
    MeasuredRow out{row, number};
    try {
      if (row.kind == Kind::Note) {
        find_targets(out);
        return out;
      }
      for (const FeatureRow& feature : row.of) add(feature, out);
      measure(out);
      if (row.kind == Kind::Depth && goes_through(*surface(out.parts[0]), out.of[0], context_)) {
        throw NoDepth(
            "the hole goes through its part, so it has no depth: measure its `diameter`, or the "
            "`distance` of the faces at its ends");
      }
    } catch (const LostPlace&) {
      throw;
    } catch (const NoDepth&) {
      throw;
    } catch (const UsageError& e) {
      throw UsageError(fmt::format("{}{}: {}", row.place, called(out), e.what()));
    }
    return out;
  }

  const std::shared_ptr<const Surface>& surface(std::size_t part) {
    return forms_.surface(scene_.parts[part].form);
  }

  /// A row by the numbers that its features have now, with what they look like.
  DimensionRow kept(DimensionRow row, const MeasuredRow& measured,
                    const std::vector<std::string>& selectors) {
    for (std::size_t k = 0; k < measured.of.size(); ++k) {
      FeatureRow& one = row.of[measured.target.empty() ? k : measured.target[k]];
      if (one.kind == FeatureRow::Kind::Point || one.kind == FeatureRow::Kind::Part) continue;
      const std::size_t part = measured.parts[k];
      const bool face = one.kind == FeatureRow::Kind::Face;
      const FeatureIndex& index = index_of(part, face);
      one.part = selectors[part];
      one.number = measured.of[k].number;
      one.print = face ? index.face(*one.number) : index.edge(*one.number);
    }
    return row;
  }

 private:
  std::vector<std::size_t> parts_of(const FeatureRow& feature) const {
    std::vector<std::size_t> parts;
    if (feature.part.empty()) {
      for (std::size_t i = 0; i < drawn_.size(); ++i) parts.push_back(i);
    } else {
      parts = select(scene_, feature.part);
    }
    std::erase_if(parts, [&](std::size_t i) { return !drawn_[i]; });
    if (parts.empty()) {
      throw UsageError(fmt::format("part '{}' is not drawn", feature.part));
    }
    return parts;
  }

  /// Each part that a selector names stands for the others.
  void find_targets(MeasuredRow& out) {
    const std::vector<FeatureRow> wanted = std::exchange(out.row.of, {});
    for (std::size_t t = 0; t < wanted.size(); ++t) {
      if (wanted[t].kind == FeatureRow::Kind::Part) {
        for (const std::size_t part : parts_of(wanted[t])) {
          out.of.emplace_back();
          out.parts.push_back(part);
        }
      } else {
        add(wanted[t], out);
      }
      out.row.of.resize(out.of.size(), wanted[t]);
      out.target.resize(out.of.size(), t);
    }
    out.moves.resize(out.of.size(), Vec3(0));
    find_values(out);
  }

  /// What the braces of a note ask for.
  void find_values(MeasuredRow& out) {
    for (const std::string& name : note_values()) {
      if (out.row.text.find("{" + name + "}") == std::string::npos) continue;
      const Feature* first = out.of.empty() ? nullptr : &out.of.front();
      const std::size_t part = first ? out.parts.front() : MeasuredRow::kNoPart;
      const FeatureRow::Kind kind = first ? out.row.of.front().kind : FeatureRow::Kind::Point;
      std::optional<double> value;
      if (part != MeasuredRow::kNoPart) {
        out.part_name = name_as_read(scene_.parts[part].name);
        if (name == "part.name" || name == "item") value = 0;
        if (name == "volume") value = scene_.parts[part].form->measure(context_).volume;
        if (name == "length" && kind == FeatureRow::Kind::Edge) value = first->size;
        if (name == "area" && kind == FeatureRow::Kind::Face) value = first->size;
        if (name == "area" && kind == FeatureRow::Kind::Part) {
          value = scene_.parts[part].form->measure(context_).area;
        }
        if (first->is_round() && name == "diameter") value = 2 * first->radius;
        if (first->is_round() && name == "radius") value = first->radius;
      }
      if (!value || (name == "volume" && !(*value > 0))) {
        throw UsageError(fmt::format("what it points at has no {{{}}}{}", name,
                                     name == "volume" ? ", its part is open" : ""));
      }
      out.values[name] = *value;
    }
  }

  void add(const FeatureRow& row, MeasuredRow& out) {
    if (row.kind == FeatureRow::Kind::Point) {
      out.of.push_back(point_feature(row.at));
      out.parts.push_back(MeasuredRow::kNoPart);
      return;
    }
    auto [part, number] = row.number ? numbered(row) : nearest(row);
    const std::shared_ptr<const Surface> there = surface(part);
    const bool face = row.kind == FeatureRow::Kind::Face;
    if (row.print) number = found_again(row, part, number);
    const auto found = face ? face_feature(*there, number, context_) : edge_feature(*there, number);
    if (!found) throw UsageError(not_there(row, part, number));
    out.of.push_back(*found);
    out.parts.push_back(part);
  }

  std::pair<std::size_t, std::int32_t> numbered(const FeatureRow& row) const {
    const std::vector<std::size_t> parts = parts_of(row);
    if (parts.size() > 1) {
      throw UsageError(
          fmt::format("a number needs one part: {} are meant by '{}'", parts.size(), row.part));
    }
    return {parts.front(), *row.number};
  }

  const FeatureIndex& index_of(std::size_t part, bool face) {
    std::unique_ptr<FeatureIndex>& index = indices_[{part, face}];
    if (!index) index = std::make_unique<FeatureIndex>(*surface(part), !face, context_);
    return *index;
  }

  /// The number that a feature has now.
  std::int32_t found_again(const FeatureRow& row, std::size_t part, std::int32_t number) {
    const bool face = row.kind == FeatureRow::Kind::Face;
    const FeatureIndex& index = index_of(part, face);
    const auto found =
        face ? index.find_face(*row.print, number) : index.find_edge(*row.print, number);
    if (found) return *found;
    throw LostPlace(fmt::format("{} {} of part '{}' was {}, and nothing like it is left",
                                face ? "face" : "edge", number, path_of(scene_.parts[part]),
                                described(*row.print)));
  }

  static std::string described(const FeaturePrint& print) {
    Feature f;
    f.kind = print.kind;
    if (f.is_round())
      return fmt::format("{} with a radius of {:.4g} mm", to_string(f.kind), print.radius);
    return fmt::format("{} of {:.4g} {}", to_string(f.kind), print.size,
                       f.kind == FeatureKind::Line ? "mm" : "mm2");
  }

  /// Of the parts whose boxes are nearer than what was found.
  std::pair<std::size_t, std::int32_t> nearest(const FeatureRow& row) {
    std::vector<std::pair<double, std::size_t>> order;
    for (const std::size_t part : parts_of(row)) {
      const Box3 box = scene_.parts[part].form->bounds(Mat3(1));
      order.emplace_back(glm::distance(glm::clamp(row.at, box.min, box.max), row.at), part);
    }
    std::ranges::sort(order);
    std::size_t of = order.front().second;
    NearFeature best{-1, std::numeric_limits<double>::infinity()};
    for (const auto& [least, part] : order) {
      if (least >= best.distance) break;
      const bool face = row.kind == FeatureRow::Kind::Face;
      const NearFeature found =
          face ? nearest_face(*surface(part), row.at) : nearest_edge(*surface(part), row.at);
      if (found.distance < best.distance) best = found, of = part;
    }
    if (!(best.distance <= kNear * diagonal_)) {
      const std::string what = row.kind == FeatureRow::Kind::Face ? "face" : "edge";
      throw UsageError(
          std::isfinite(best.distance)
              ? fmt::format("no {} is at {:g},{:g},{:g}: the nearest is {:.3g} mm away", what,
                            row.at.x, row.at.y, row.at.z, best.distance)
              : fmt::format("there is no {} to measure", what));
    }
    return {of, best.number};
  }

  std::string not_there(const FeatureRow& row, std::size_t part, std::int32_t number) {
    const std::string name = path_of(scene_.parts[part]);
    const ProxyMesh& proxy = surface(part)->proxy();
    std::int32_t last = -1;
    if (row.kind == FeatureRow::Kind::Edge) {
      for (const std::int32_t edge : proxy.source_edge) last = std::max(last, edge);
      if (last < 0) {
        return fmt::format("part '{}' has no numbered edges: name its faces, or a \"point\"", name);
      }
      return fmt::format("part '{}' has no edge {}: they are 0 to {}", name, number, last);
    }
    for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
      if (!proxy.is_cut(t)) last = std::max(last, proxy.face_source(t));
    }
    return fmt::format("part '{}' has no face {}: they are 0 to {}", name, number, last);
  }

  static void refuse(const MeasuredRow& row, const char* what, const char* instead) {
    throw UsageError(fmt::format(
        "{} {} has no {}: {}", to_string(row.of[0].kind),
        row.of[0].number < 0 ? std::string("there") : fmt::format("(number {})", row.of[0].number),
        what, instead));
  }

  static void measure(MeasuredRow& out) {
    const Feature& first = out.of[0];
    using F = FeatureKind;
    switch (out.row.kind) {
      case Kind::Note:
        break;
      case Kind::Distance:
        out.distance = distance_between(first, out.of[1], out.row.along);
        out.value = out.distance.length;
        break;
      case Kind::Angle:
        if (out.of.size() == 1) {
          if (first.kind != F::Cone) {
            refuse(out, "angle of its own", "name a cone, or two features");
          }
          out.angle = {.degrees = first.opening, .vertex = apex_of(first)};
          out.value = first.opening;
          break;
        }
        out.angle = angle_between(first, out.of[1]);
        if (out.row.supplement) {
          out.angle.second = -out.angle.second;
          out.angle.degrees = 180 - out.angle.degrees;
        }
        out.value = out.angle.degrees;
        break;
      case Kind::Diameter:
      case Kind::Thread:
        if (!first.is_round() || first.kind == F::Torus) {
          refuse(out, "diameter", "name a cylinder, a cone, a sphere or a round edge");
        }
        out.value = 2 * first.radius;
        break;
      case Kind::Radius:
        if (!first.is_round() || first.kind == F::Cone || first.kind == F::Turned) {
          refuse(out, "radius", "name a cylinder, a sphere, a torus or a round edge");
        }
        out.value = first.radius;
        break;
      case Kind::Depth:
        if (!first.has_axis() || !first.hollow || !(first.high > first.low)) {
          refuse(out, "depth", "name the wall of a hole");
        }
        out.value = first.high - first.low;
        break;
    }
  }

  Scene& scene_;
  std::vector<bool> drawn_;
  double diagonal_;
  RunContext& context_;
  RealisedForms forms_;
  std::map<std::pair<std::size_t, bool>, std::unique_ptr<FeatureIndex>> indices_;
};

/// The surfaces of features in a scene; null where nothing of one is left.
std::vector<std::shared_ptr<const Surface>> surfaces_there(const Scene& scene,
                                                           const MeasuredRow& row,
                                                           RealisedForms& forms,
                                                           RunContext& context) {
  std::vector<std::shared_ptr<const Surface>> out;
  for (std::size_t k = 0; k < row.of.size(); ++k) {
    std::shared_ptr<const Surface>& one = out.emplace_back();
    if (row.parts[k] == MeasuredRow::kNoPart) continue;
    try {
      one = forms.surface(scene.parts[row.parts[k]].form);
    } catch (const GeometryError&) {
      continue;  // nothing of the part is left, or it cannot be drawn, which is told elsewhere
    }
    if (row.row.of[k].kind == FeatureRow::Kind::Part) {
      if (one->proxy().mesh.triangles.empty()) one.reset();
      continue;
    }
    const bool face = row.row.of[k].kind == FeatureRow::Kind::Face;
    const bool left = face ? face_feature(*one, row.of[k].number, context).has_value()
                           : edge_feature(*one, row.of[k].number).has_value();
    if (!left) one.reset();
  }
  return out;
}

/// Nothing where a feature lost its place or has no depth, which is told.
std::optional<MeasuredRow> measured_row(Scene& scene, Measurer& measurer, const DimensionRow& row,
                                        std::size_t number) {
  const auto tell = [&](const char* code, const std::string& what) {
    MeasuredRow one;
    one.row = row;
    one.number = number;
    tell_of(one, code, what, scene.diagnostics);
  };
  try {
    return measurer.measured(row, number);
  } catch (const LostPlace& e) {
    tell("dimensions.lost", fmt::format("lost its place and is not drawn: {}", e.what()));
  } catch (const NoDepth& e) {
    tell("dimensions.not_drawn", fmt::format("is not drawn: {}", e.what()));
  }
  return std::nullopt;
}

}  // namespace

std::string called(const MeasuredRow& row) {
  if (row.row.kind == Kind::Note) return fmt::format("note {}", row.number);
  return fmt::format("dimension {} ({})", row.number, to_string(row.row.kind));
}

void tell_of(const MeasuredRow& row, const char* code, const std::string& what,
             Diagnostics& diagnostics) {
  diagnostics.add(Severity::Warning, code, 1,
                  fmt::format("{}{} {}", row.row.place, called(row), what));
}

void measure_rows(Scene& scene, Illustration& illustration, RunContext& context) {
  illustration.measured.clear();
  if (illustration.dimensions.empty() && illustration.note_rows.empty()) return;
  Measurer measurer(scene, illustration, context);
  for (const auto* rows : {&illustration.dimensions, &illustration.note_rows}) {
    for (std::size_t i = 0; i < rows->size(); ++i) {
      context.check();
      auto one = measured_row(scene, measurer, (*rows)[i], i + 1);
      if (!one) continue;
      std::vector<std::shared_ptr<const Surface>>& there = one->there.emplace_back();
      for (const std::size_t part : one->parts) {
        there.push_back(part == MeasuredRow::kNoPart ? nullptr : measurer.surface(part));
      }
      illustration.measured.push_back(*std::move(one));
    }
  }
}

void look_at_cuts(const Scene& scene, Illustration& illustration, RunContext& context) {
  if (illustration.sections.empty()) return;
  RealisedForms forms(scene.bounds().diagonal(), context);
  const bool whole = std::ranges::all_of(illustration.sections, &Section::own_view);
  for (MeasuredRow& row : illustration.measured) {
    if (!whole) row.there[0] = surfaces_there(scene, row, forms, context);
    for (const SectionView& view : illustration.section_views) {
      row.there.push_back(surfaces_there(*view.scene, row, forms, context));
    }
  }
}

void move_rows(Scene& scene, Illustration& illustration, const std::vector<Vec3>& moves) {
  std::erase_if(illustration.measured, [&](MeasuredRow& row) {
    if (row.row.kind == DimensionRow::Kind::Note) {
      for (std::size_t k = 0; k < row.parts.size(); ++k) {
        if (row.parts[k] != MeasuredRow::kNoPart) row.moves[k] = moves[row.parts[k]];
      }
      return false;
    }
    std::optional<Vec3> moved;
    for (const std::size_t part : row.parts) {
      const Vec3 move = part == MeasuredRow::kNoPart ? Vec3(0) : moves[part];
      if (moved && glm::distance(*moved, move) > 0) {
        tell_of(row, "dimensions.not_drawn", "is not drawn: its parts have come apart",
                scene.diagnostics);
        return true;
      }
      moved = move;
    }
    row.moved = moved.value_or(Vec3(0));
    return false;
  });
}

}  // namespace detail

void detail::number_notes(Illustration& illustration) {
  const auto& over = illustration.illustrate.annotations;
  for (MeasuredRow& row : illustration.measured) {
    if (!row.values.contains("item") || !over) continue;
    const auto part = static_cast<std::int32_t>(row.parts.front());
    for (const DrawingItem& item : over->items) {
      if (std::ranges::find(item.parts, part) != item.parts.end()) row.item = item.number;
    }
  }
}

void keep_features(Scene& scene, Illustration& illustration, RunContext& context) {
  detail::Measurer measurer(scene, illustration, context);
  const std::vector<std::string> selectors = selectors_of(scene);
  for (auto* rows : {&illustration.dimensions, &illustration.note_rows}) {
    for (std::size_t i = 0; i < rows->size(); ++i) {
      if (const auto one = detail::measured_row(scene, measurer, (*rows)[i], i + 1)) {
        (*rows)[i] = measurer.kept((*rows)[i], *one, selectors);
      }
    }
  }
}

}  // namespace burin
