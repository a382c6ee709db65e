#include "difference_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace burin::detail {
namespace {

/// Share of a number by which another has to differ to be told as another one.
constexpr double kTold = 1e-6;

std::string plural(std::size_t n, const char* word) {
  return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
}

/// Five digits; rounding is not told as a number.
std::string number(double value, double size) {
  return fmt::format("{:.5g}", std::abs(value) <= kTold * size ? 0.0 : value);
}

std::string vector_text(Vec3 v) {
  const double size = glm::length(v);
  return fmt::format("({}, {}, {})", number(v.x, size), number(v.y, size), number(v.z, size));
}

std::string box_text(Vec3 v) {
  const double size = glm::length(v);
  return fmt::format("{} x {} x {}", number(v.x, size), number(v.y, size), number(v.z, size));
}

void add(std::string& text, const std::string& more) {
  if (!text.empty()) text += "; ";
  text += more;
}

void add_change(std::string& text, const char* what, double before, double after,
                const char* unit) {
  if (std::abs(after - before) <= kTold * std::max(std::abs(before), std::abs(after))) return;
  std::string share;
  if (before != 0) share = fmt::format(" ({:+.3g} %)", 100 * (after - before) / before);
  add(text, fmt::format("{} {:.6g} to {:.6g} {}{}", what, before, after, unit, share));
}

std::string size_text(const PartNumbers& n) {
  std::string text;
  if (n.volume != 0) add(text, fmt::format("volume {:.6g} mm3", n.volume));
  if (n.area != 0) add(text, fmt::format("area {:.6g} mm2", n.area));
  add(text, fmt::format("box {} mm", box_text(n.box)));
  return text;
}

std::string motion_text(const PartMotion& motion) {
  constexpr double kStill = 1e-3;  // degrees
  std::string text = fmt::format("by {:.5g} mm {}", glm::length(motion.by), vector_text(motion.by));
  if (!motion.degrees) {
    text += ", turned by an angle that was not found";
  } else if (*motion.degrees > kStill) {
    text +=
        fmt::format(", turned {:.4g} degrees about {}", *motion.degrees, vector_text(motion.axis));
  }
  return text;
}

std::string color_text(const std::string& color) { return color.empty() ? "none" : color; }

std::string what_of(const PartDifference& part) {
  if (!part.numbers_before) return size_text(*part.numbers_after);
  if (!part.numbers_after) return size_text(*part.numbers_before);
  std::string text;
  const PartNumbers &was = *part.numbers_before, &is = *part.numbers_after;
  if (part.match.changed) {
    add_change(text, "volume", was.volume, is.volume, "mm3");
    add_change(text, "area", was.area, is.area, "mm2");
    const Vec3 off = glm::abs(is.box - was.box);
    if (std::max({off.x, off.y, off.z}) > 1e-5 * glm::length(was.box)) {
      add(text, fmt::format("box {} to {} mm", box_text(was.box), box_text(is.box)));
    }
    add(text, fmt::format("{:.3g} % of the surface", 100 * part.surface_changed));
  }
  if (part.motion) add(text, "moved " + motion_text(*part.motion));
  if (part.match.renamed) add(text, fmt::format("was called {}", part.before));
  if (part.drawn_before != part.drawn_after) add(text, part.drawn_after ? "shown" : "left out");
  if (part.color_before != part.color_after) {
    add(text, fmt::format("colour {} to {}", color_text(part.color_before),
                          color_text(part.color_after)));
  }
  if (part.match.face_colors) add(text, "other colours of faces");
  if (part.match.look && part.opacity_before != part.opacity_after) {
    add(text, fmt::format("opacity {:.3g} to {:.3g}", part.opacity_before, part.opacity_after));
  }
  return text;
}

/// "Spot 15 %".
std::string ink_text(const InkTint& ink) {
  return ink.ink.empty() ? "none" : fmt::format("{} {:.4g} %", ink.ink, 100 * ink.tint);
}

std::string change_text(const ChangedFill& fill) {
  std::string text;
  if (fill.before != fill.after) {
    add(text, fmt::format("colour {} to {}", color_text(fill.before), color_text(fill.after)));
  }
  if (fill.ink_before != fill.ink_after) {
    add(text, fmt::format("ink {} to {}", ink_text(fill.ink_before), ink_text(fill.ink_after)));
  }
  return text;
}

/// One row a part: its largest change of colour, and how much of it has changed.
void add_fill_rows(const std::vector<ChangedFill>& fills, std::vector<DifferenceRow>& rows) {
  for (auto first = fills.begin(); first != fills.end();) {
    const auto last = std::find_if(first, fills.end(),
                                   [&](const ChangedFill& one) { return one.part != first->part; });
    double size = 0;
    for (auto it = first; it != last; ++it) size += it->size;
    const auto more = static_cast<std::size_t>(last - first) - 1;
    std::string what = change_text(*first);
    if (more > 0) what += fmt::format(" and {} more", more);
    rows.push_back({0, "changed", first->part.empty() ? "shadow" : first->part,
                    fmt::format("{}, {:.4g} mm2", what, size)});
    first = last;
  }
}

}  // namespace

std::vector<DifferenceRow> rows_of(const Difference& difference) {
  std::vector<DifferenceRow> rows;
  int item = 0;
  for (const PartDifference& part : difference.parts) {
    rows.push_back({++item, to_string(part.change()), part.after.empty() ? part.before : part.after,
                    what_of(part)});
  }
  return rows;
}

std::vector<DifferenceRow> rows_of(const LineDifference& difference) {
  struct Sum {
    std::size_t lines = 0;
    double length = 0, distance = 0;
  };
  std::map<std::tuple<LineChange, std::string, std::string>, Sum> sums;
  for (const ChangedLine& line : difference.lines) {
    Sum& sum = sums[{line.change, line.part, line.layer}];
    ++sum.lines;
    sum.length += line.length;
    sum.distance = std::max(sum.distance, line.distance);
  }
  std::vector<DifferenceRow> rows;
  for (const auto& [key, sum] : sums) {
    const auto& [change, part, layer] = key;
    std::string what = fmt::format("{}, {:.4g} mm", plural(sum.lines, "line"), sum.length);
    if (change == LineChange::Moved) what += fmt::format(", as far as {:.3g} mm", sum.distance);
    rows.push_back({0, to_string(change), part.empty() ? layer : part + ", " + layer, what});
  }
  add_fill_rows(difference.fills, rows);
  for (const ChangedInk& ink : difference.inks) {
    const char* how = ink.before.empty() ? "new" : ink.after.empty() ? "gone" : "changed";
    const std::string what = ink.before.empty() || ink.after.empty()
                                 ? "colour " + ink.before + ink.after
                                 : fmt::format("colour {} to {}", ink.before, ink.after);
    rows.push_back({0, how, "ink " + ink.name, what});
  }
  for (const Text& text : difference.texts_new) {
    rows.push_back({0, "new", "text", fmt::format("'{}'", text.text)});
  }
  for (const Text& text : difference.texts_gone) {
    rows.push_back({0, "gone", "text", fmt::format("'{}'", text.text)});
  }
  if (!difference.same_sheet) rows.push_back({0, "changed", "sheet", "its size is another one"});
  return rows;
}

std::string counts_of(const Difference& difference, std::size_t before, std::size_t after) {
  std::string text = before == after
                         ? plural(after, "part") + ": "
                         : plural(before, "part") + fmt::format(" before, {} now: ", after);
  bool first = true;
  for (const PartChange change :
       {PartChange::Same, PartChange::Changed, PartChange::Moved, PartChange::Added,
        PartChange::Removed, PartChange::Renamed, PartChange::Look}) {
    const std::size_t n = difference.count(change);
    if (n == 0 && !(change == PartChange::Same)) continue;
    text += fmt::format("{}{} {}", first ? "" : ", ", n,
                        change == PartChange::Look ? "of another look" : to_string(change));
    first = false;
  }
  return text;
}

std::string counts_of(const LineDifference& difference) {
  std::string text;
  for (const LineChange change :
       {LineChange::Same, LineChange::New, LineChange::Gone, LineChange::Moved}) {
    const auto i = static_cast<std::size_t>(change);
    if (difference.counts[i] == 0 && change != LineChange::Same) continue;
    text +=
        fmt::format("{}{} {} ({:.4g} mm)", text.empty() ? "" : ", ",
                    plural(difference.counts[i], "line"), to_string(change), difference.lengths[i]);
  }
  std::set<std::string> parts;
  for (const ChangedFill& fill : difference.fills) parts.insert(fill.part);
  if (!parts.empty()) text += fmt::format(", {} of other colours", plural(parts.size(), "part"));
  if (const std::size_t n = difference.inks.size(); n > 0) {
    text += ", " + plural(n, "changed spot ink");
  }
  const std::size_t texts = difference.texts_new.size() + difference.texts_gone.size();
  if (texts > 0) text += fmt::format(", {} of texts", plural(texts, "change"));
  return text;
}

}  // namespace burin::detail
