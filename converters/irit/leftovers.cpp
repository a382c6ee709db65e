#include "leftovers.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::irit {
namespace {

/// Of a polygon that has an area.
constexpr std::size_t kLeastCorners = 3;

constexpr const char* kUnreadCode = "irit.unread";
constexpr const char* kNoSurface = "irit.no_surface";
constexpr const char* kNoOriginal = "irit.no_original";
constexpr const char* kInvisible = "irit.invisible";

struct LeftoverWords {
  std::string_view keyword, words;
};
constexpr LeftoverWords kWords[] = {
    {"TRIMSRF", "trimmed surface"},  {"MODEL", "model of trimmed surfaces"},
    {"VMODEL", "volumetric model"},  {"TRIMMODEL", "model of trimmed surfaces"},
    {"TRIVAR", "trivariate volume"}, {"MULTIVAR", "multivariate function"},
    {"TRISRF", "triangular patch"}};

struct Why {
  std::string_view code, words;
  Severity severity;
};
constexpr Why kWhy[] = {
    {kUnreadCode, "is not yet read and was left out", Severity::Warning},
    {kNoOriginal, "was left out: the file has no object of that name", Severity::Warning},
    {kNoSurface, "is no surface and was left out", Severity::Warning},
    {kInvisible, "were left out", Severity::Info}};

const Why& why_of(std::string_view code) { return *std::ranges::find(kWhy, code, &Why::code); }

std::string in_words(const std::string& what) {
  // "TRIVAR of points E3" is named by its first word.
  const auto* it = std::ranges::find(kWords, std::string_view(what).substr(0, what.find(' ')),
                                     &LeftoverWords::keyword);
  return it == std::end(kWords) ? what : fmt::format("{} ({})", what, it->words);
}

}  // namespace

void Leftovers::count(const std::string& code, const std::string& what, std::int64_t line) {
  auto it = std::ranges::find(kinds_, what, &Kind::what);
  if (it == kinds_.end()) it = kinds_.insert(it, {code, what, 0, line});
  ++it->count;
}

void Leftovers::add(const IritItem& item, std::int64_t object_line) {
  // Names come from the file: a damaged one must not make a list of thousands.
  constexpr std::size_t kMaxKinds = 50;
  const bool many = kinds_.size() >= kMaxKinds;
  if (const auto* unread = std::get_if<IritUnread>(&item)) {
    count(kUnreadCode, many ? "other blocks" : in_words(unread->what), unread->line);
  } else if (const auto* instance = std::get_if<IritInstance>(&item)) {
    count(kNoOriginal, many ? "other INSTANCE" : fmt::format("INSTANCE of {}", instance->of),
          instance->place.line);
  } else if (std::holds_alternative<IritCurve>(item)) {
    count(kNoSurface, "CURVE", object_line);
  } else if (const auto* polygon = std::get_if<IritPolygon>(&item)) {
    if (polygon->kind == IritPolygon::Kind::Polyline) count(kNoSurface, "POLYLINE", object_line);
    if (polygon->kind == IritPolygon::Kind::PointList) count(kNoSurface, "POINTLIST", object_line);
    const bool area =
        polygon->kind == IritPolygon::Kind::Polygon || polygon->kind == IritPolygon::Kind::Strip;
    if (area && polygon->points.size() < kLeastCorners) {
      count(kNoSurface, "POLYGON of fewer than three corners", object_line);
    }
  }
}

void Leftovers::add_invisible(std::int64_t line) {
  count(kInvisible, "objects marked invisible", line);
}

void Leftovers::report(Diagnostics& diagnostics) const {
  for (const Kind& kind : kinds_) {
    const Why& why = why_of(kind.code);
    diagnostics.add(why.severity, kind.code, kind.count,
                    fmt::format("{} {}; the first on line {}", kind.what, why.words, kind.line));
  }
}

std::string Leftovers::nothing_else() const {
  if (kinds_.empty()) return "holds no surface; export the model with its surfaces";
  std::string all;
  bool unread = false;
  for (const Kind& kind : kinds_) {
    unread |= kind.code == kUnreadCode;
    all += fmt::format("{}{} {}", all.empty() ? "" : ", ", kind.count, kind.what);
  }
  return unread ? fmt::format(
                      "holds nothing that is read so far, only {}; convert it to surfaces "
                      "or polygons",
                      all)
                : fmt::format("holds no surface, only {}; export the model with its surfaces", all);
}

std::int64_t Leftovers::first_line() const { return kinds_.empty() ? 0 : kinds_.front().line; }

}  // namespace burin::irit
