#include "eps.h"

#include <burin/drawing/font.h>
#include <burin/drawing/near_sheet.h>
#include <burin/drawing/ordered_text.h>
#include <burin/drawing/text.h>
#include <burin/drawing/title.h>

#include "eps_areas.h"
#include "eps_pen.h"
#include "own_formats.h"

#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr double kStraight = 0.0005;  // paper mm; as in the other formats

/// One path, text or area with what comes before it.
struct Item {
  std::string before;
  const Path* path = nullptr;
  const Text* text = nullptr;
  std::optional<std::size_t> area = {};
};

/// Text for a comment: one line of printable ASCII, as DSC asks for.
std::string plain_text(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 200)) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

std::string head(const Drawing& drawing) {
  const double w = drawing.paper_width * kPointsPerMm, h = drawing.paper_height * kPointsPerMm;
  const bool painted = drawing.paper_color != Drawing().paper_color;
  const std::string ink = eps_color(drawing.ink_color);
  const std::string paper =
      painted ? fmt::format("{} 0 0 {:.5f} {:.5f} rectfill\n", eps_color(drawing.paper_color), w, h)
              : "";
  return fmt::format(
      "%!PS-Adobe-3.0 EPSF-3.0\n%%Creator: {}\n%%Title: {}\n%%BoundingBox: 0 0 {} {}\n"
      "%%HiResBoundingBox: 0 0 {:.5f} {:.5f}\n%%DocumentData: Clean7Bit\n%%LanguageLevel: 2\n"
      "%%Pages: 1\n%%EndComments\n%%BeginProlog\n"
      "/burin 12 dict def burin begin\n/m{{moveto}}bind def/l{{rlineto}}bind def\n"
      "/c{{rcurveto}}bind def/h{{closepath}}bind def\n/f{{fill}}bind def/s{{stroke}}bind def\n"
      "/w{{setlinewidth}}bind def end\n%%EndProlog\n%%Page: 1 1\nsave burin begin\n"
      "0 0 {:.5f} {:.5f} rectclip\n{}{:.12f} dup scale\n{} 1 setlinecap 1 setlinejoin\n",
      creator(), plain_text(title_of(drawing)), std::ceil(w), std::ceil(h), w, h, w, h, paper,
      kPointsPerMm / kUnitsPerMm, ink);
}

/// `first`: where a line without a curve is a dot; `closed`: its ends are joined.
void append_ink(Buffer& out, const Ink& ink, Vec2 first, bool closed) {
  EpsPen pen(out);
  for (const auto& chain : ink.chains) {
    pen.move(chain.empty() ? first : chain.front()[0]);
    if (chain.empty()) pen.line(first);
    for (const CubicBezier& c : chain) {
      if (is_straight(c, kStraight)) {
        pen.line(c[3]);
      } else {
        pen.curve(c);
      }
    }
    if (!chain.empty() && (ink.filled || closed)) append(out, "h\n");
  }
  if (ink.filled) return append(out, "f\n");
  fmt::format_to(fmt::appender(out), "{} w s\n", std::llround(ink.width * kUnitsPerMm));
}

std::vector<Item> items_of(const std::vector<InkLayer>& layers, std::string before,
                           const Drawing& drawing, const EpsAreas& areas,
                           const SvgOptions& options) {
  std::vector<Item> items;
  std::string used = drawing.ink_color;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const std::string color = areas.color(i);
    if (color != used) before += eps_color(used = color) + "\n";
    items.push_back({std::move(before), nullptr, nullptr, i});
    before.clear();
  }
  for (const InkLayer& layer : layers) {
    before += fmt::format("% layer {}\n", plain_text(layer.name));
    const auto use = [&](const std::string& color) {
      if (color == used) return;
      before += eps_color(color) + "\n";
      used = color;
    };
    use(ink_color(layer, drawing));
    const auto use_dashes = [&](std::vector<double> dashes) {
      for (double& length : dashes) length = std::round(length * kUnitsPerMm);
      before += fmt::format("[{}] 0 setdash\n", fmt::join(dashes, " "));
    };
    const std::vector<double> dashes = layer.dashes(options.dashes);
    use_dashes(dashes);
    for (const auto& [part, paths] : layer.parts) {
      for (const Path* path : paths) {
        use(ink_color(*path, layer, drawing));
        if (!dashes.empty()) use_dashes(fitted_dashes(dashes, *path));
        items.push_back({std::move(before), path});
        before.clear();
      }
    }
    for (const Text* text : layer.texts) {
      use(ink_color(layer, drawing));
      items.push_back({std::move(before), nullptr, text});
      before.clear();
    }
  }
  items.push_back({before + "end restore\nshowpage\n%%Trailer\n%%EOF\n", nullptr});
  return items;
}

}  // namespace

void write_eps(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
               const RunContext& context) {
  const NearSheet sheet(drawing);
  const EpsAreas areas(drawing);
  const std::vector<Item> items =
      items_of(sheet.layers(), head(drawing), drawing, areas, options.svg);
  write_ordered(
      items.size(), [&](std::size_t i) { return items[i].path ? items[i].path->points.size() : 0; },
      [&](std::size_t i, Buffer& buffer) {
        append(buffer, items[i].before);
        if (items[i].area) areas.append(buffer, *items[i].area);
        if (const Path* path = items[i].path) {
          append_ink(buffer, ink_of(*path, options.svg.fit_tolerance), path->points.front(),
                     path->closed);
        } else if (items[i].text) {
          const Ink ink = text_ink(*items[i].text);
          if (!ink.chains.empty()) append_ink(buffer, ink, Vec2(0), true);
        }
      },
      out, context);
}

namespace detail {

Format eps_format() { return {"eps", {}, write_eps}; }

}  // namespace detail
}  // namespace burin
