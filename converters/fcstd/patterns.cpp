#include "patterns.h"

#include "document.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin::detail {
namespace {

constexpr std::int64_t kMostCopies = 10'000;

std::vector<std::string> linked(const pugi::xml_node& list) {
  std::vector<std::string> out;
  for (const pugi::xml_node& one : list.children("Link")) out.push_back(text_of(one));
  return out;
}

/// A straight line, or a plane by its normal, in the frame of a body.
struct Reference {
  Vec3 point{0}, along{0, 0, 1};
};

/// Of the axes and planes that each body has: which unit vector they stand for.
std::optional<Vec3> of_origin(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, int>, 6> kNames{{{"X_Axis", 0},
                                                                    {"Y_Axis", 1},
                                                                    {"Z_Axis", 2},
                                                                    {"YZ_Plane", 0},
                                                                    {"XZ_Plane", 1},
                                                                    {"XY_Plane", 2}}};
  for (const auto& [begin, axis] : kNames) {
    if (!name.starts_with(begin)) continue;
    Vec3 out(0);
    out[axis] = 1;
    return out;
  }
  return std::nullopt;
}

/// Of a sketch its axes; as a plane that which goes through an axis and stands on the sketch.
std::optional<Vec3> of_sketch(std::string_view sub, bool plane) {
  if (sub == "H_Axis") return plane ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  if (sub == "V_Axis") return plane ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  if (sub == "N_Axis" || sub.empty()) return Vec3(0, 0, 1);
  return std::nullopt;
}

std::optional<Reference> reference_of(const FcDocument& document, const FcPattern& pattern) {
  const std::int32_t number = document.find(pattern.reference);
  if (number < 0) return std::nullopt;
  const FcObject& object = document.objects()[static_cast<std::size_t>(number)];
  if (object.is("App::Line") || object.is("App::Plane")) {
    const auto along = of_origin(object.name);
    return along ? std::optional(Reference{Vec3(0), *along}) : std::nullopt;
  }
  if (object.is("PartDesign::Line") || object.is("PartDesign::Plane")) {
    return Reference{object.placement.offset, object.placement.vector({0, 0, 1})};
  }
  if (!object.type.starts_with("Sketcher::")) return std::nullopt;
  const auto along = of_sketch(pattern.sub, pattern.kind == FcPattern::Kind::Mirrored);
  if (!along) return std::nullopt;
  return Reference{object.placement.offset, object.placement.vector(*along)};
}

/// About an axis, by the right hand.
Placement turned(const Reference& axis, double degrees) {
  const double a = glm::radians(degrees), s = std::sin(a), c = std::cos(a);
  const Vec3& n = axis.along;
  Placement out;
  for (int k = 0; k < 3; ++k) {
    Vec3 unit(0);
    unit[k] = 1;
    out.linear[k] = c * unit + s * glm::cross(n, unit) + (1 - c) * glm::dot(n, unit) * n;
  }
  out.offset = axis.point - out.linear * axis.point;
  return out;
}

Placement mirrored(const Reference& plane) {
  Placement out;
  out.linear = Mat3(1) - 2.0 * glm::outerProduct(plane.along, plane.along);
  out.offset = 2 * glm::dot(plane.point, plane.along) * plane.along;
  return out;
}

/// From each copy to the next, mm or degrees.
double step_of(const FcPattern& pattern, std::int64_t count) {
  if (pattern.spaced) return pattern.step;
  const bool round = pattern.kind == FcPattern::Kind::Polar && std::abs(pattern.extent) >= 360;
  return pattern.extent / static_cast<double>(round ? count : count - 1);
}

std::optional<std::vector<Placement>> all_of(const FcDocument& document, const FcPattern& multi) {
  std::vector<Placement> out{Placement{}};
  for (const std::string& name : multi.transformations) {
    const std::int32_t number = document.find(name);
    if (number < 0) return std::nullopt;
    const auto& one = document.objects()[static_cast<std::size_t>(number)].pattern;
    if (!one || one->kind == FcPattern::Kind::Multi) return std::nullopt;
    const auto copies = copies_of(document, *one);
    if (!copies) return std::nullopt;
    std::vector<Placement> next;
    for (const Placement& copy : *copies) {
      for (const Placement& before : out) next.push_back(after(copy, before));
    }
    next.resize(std::min<std::size_t>(next.size(), kMostCopies));
    out = std::move(next);
  }
  return out;
}

}  // namespace

std::optional<FcPattern> FcPattern::of_type(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, Kind>, 4> kTypes{
      {{"PartDesign::LinearPattern", Kind::Linear},
       {"PartDesign::PolarPattern", Kind::Polar},
       {"PartDesign::Mirrored", Kind::Mirrored},
       {"PartDesign::MultiTransform", Kind::Multi}}};
  const auto found = std::ranges::find(kTypes, type, &std::pair<std::string_view, Kind>::first);
  if (found == kTypes.end()) return std::nullopt;
  return FcPattern{.kind = found->second};
}

void FcPattern::take(std::string_view name, const pugi::xml_node& value) {
  if (name == "Originals") originals = linked(value);
  if (name == "Transformations") transformations = linked(value);
  if (name == "TransformMode") whole = number(value, "value", 0) == 1;
  if (name == "Direction" || name == "Axis" || name == "MirrorPlane") {
    reference = text_of(value);
    sub = text_of(value.child("Sub"));
  }
  if (name == "Length" || name == "Angle") extent = number(value, "value", 0);
  if (name == "Offset") step = number(value, "value", 0);
  if (name == "Mode") spaced = number(value, "value", 0) == 1;
  if (name == "Reversed") reversed = truth(value);
  if (name == "Occurrences") {
    occurrences = static_cast<std::int64_t>(
        std::clamp(number(value, "value", 1), 1.0, static_cast<double>(kMostCopies)));
  }
}

std::optional<std::vector<Placement>> copies_of(const FcDocument& document,
                                                const FcPattern& pattern) {
  if (pattern.kind == FcPattern::Kind::Multi) return all_of(document, pattern);
  const auto reference = reference_of(document, pattern);
  if (!reference) return std::nullopt;
  if (pattern.kind == FcPattern::Kind::Mirrored) {
    return std::vector<Placement>{Placement{}, mirrored(*reference)};
  }
  std::vector<Placement> out{Placement{}};
  if (pattern.occurrences < 2) return out;
  const double step = (pattern.reversed ? -1 : 1) * step_of(pattern, pattern.occurrences);
  for (std::int64_t k = 1; k < pattern.occurrences; ++k) {
    const double by = step * static_cast<double>(k);
    out.push_back(pattern.kind == FcPattern::Kind::Polar
                      ? turned(*reference, by)
                      : Placement{Mat3(1), by * reference->along});
  }
  return out;
}

}  // namespace burin::detail
