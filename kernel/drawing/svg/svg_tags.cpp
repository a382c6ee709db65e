#include "svg_tags.h"

#include <burin/base/ascii.h>
#include <burin/base/version.h>
#include <burin/drawing/font.h>
#include <burin/drawing/title.h>

#include "svg_path.h"

#include <algorithm>

namespace burin {

std::string SvgIds::make(std::string_view name) {
  std::string id = prefix_;
  for (const char c : name) {
    const bool first = is_letter(c) || c == '_';
    const bool later = is_digit(c) || c == '-' || c == '.';
    if (id.empty() && !first) id = "layer-";
    id.push_back(first || later ? c : '_');
  }
  if (id.empty()) id = "layer";
  const std::string stem = id;
  for (int i = 2; !taken_.insert(id).second; ++i) id = fmt::format("{}-{}", stem, i);
  return id;
}

std::string svg_head(const Drawing& drawing, std::string_view more) {
  Buffer out;
  append(out,
         "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"");
  const double w = drawing.paper_width, h = drawing.paper_height;
  append_fixed(out, w, 3);
  append(out, "mm\" height=\"");
  append_fixed(out, h, 3);
  append(out, "mm\" viewBox=\"0 0 ");
  append_fixed(out, w, 3);
  out.push_back(' ');
  append_fixed(out, h, 3);
  append(out, "\" role=\"img\"");
  append(out, more);
  append(out, ">\n<title>");
  append_xml(out, title_of(drawing));
  append(out, "</title>\n<desc>");
  append_xml(out,
             fmt::format("burin {}, style {}, seed {}", version(), drawing.style, drawing.seed));
  append(out, "</desc>\n");
  if (drawing.paper_color != Drawing().paper_color) {
    append(out, "<rect class=\"paper\" width=\"");
    append_fixed(out, w, 3);
    append(out, "\" height=\"");
    append_fixed(out, h, 3);
    append(out, fmt::format("\" fill=\"{}\"/>\n", drawing.paper_color));
  }
  return fmt::to_string(out);
}

std::string svg_ink(const std::string& color) {
  return color == Drawing().ink_color ? "#000" : color;
}

std::string svg_layer_tag(const InkLayer& layer, const std::string& id, std::string_view ink,
                          const SvgOptions& options) {
  Buffer out;
  append(out, fmt::format("<g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"", id));
  append_xml(out, layer.name);
  append(out, fmt::format("\" fill=\"none\" stroke=\"{}\" stroke-linecap=\"round\" "
                          "stroke-linejoin=\"round\"",
                          ink));
  append_dashes(out, layer.dashes(options.dashes));
  append(out, ">\n");
  return fmt::to_string(out);
}

std::string svg_text(const Text& text, double paper_height, std::string_view ink,
                     const SvgOptions& options) {
  Buffer out;
  if (options.flatten) {
    constexpr double kPen = 0.1;  // of the height, as letters of type B have it
    SvgPen pen(out, paper_height);
    for (std::vector<Vec2> line : text_outlines(text, options.fit_tolerance)) {
      line.push_back(line.front());
      append(out, "<polyline class=\"text\"");
      append_pen(out, kPen * text.height);
      append(out, " points=\"");
      pen.points(line);
      append(out, "\"/>\n");
    }
    return fmt::to_string(out);
  }
  append(out, "<text class=\"");
  append_xml(out, text.role.empty() ? "text" : text.role + "-text");
  append(out, "\" x=\"");
  append_fixed(out, text.at.x, 3);
  append(out, "\" y=\"");
  append_fixed(out, paper_height - text.at.y, 3);
  if (text.turn != 0) {
    append(out, "\" transform=\"rotate(");
    append_fixed(out, -text.turn, 6);
    append(out, " ");
    append_fixed(out, text.at.x, 3);
    append(out, " ");
    append_fixed(out, paper_height - text.at.y, 3);
    append(out, ")");
  }
  append(out, "\" font-size=\"");
  append_fixed(out, font_size(text.height), 3);
  append(out, fmt::format("\" font-family=\"{}, sans-serif\" text-anchor=\"{}\" fill=\"{}\" "
                          "stroke=\"none\">",
                          kFontFamily, to_string(text.anchor), ink));
  append_xml(out, text.text);
  append(out, "</text>\n");
  return fmt::to_string(out);
}

void append_dashes(Buffer& out, const std::vector<double>& dashes) {
  for (std::size_t i = 0; i < dashes.size(); ++i) {
    append(out, i == 0 ? " stroke-dasharray=\"" : " ");
    append_fixed(out, dashes[i], 3);
  }
  if (!dashes.empty()) out.push_back('"');
}

void append_pen(Buffer& out, double width) {
  append(out, " stroke-width=\"");
  append_fixed(out, width, 3);
  out.push_back('"');
}

double curve_tolerance(const SvgOptions& options) {
  // What rounding to the grid and writing nearly straight curves as lines may add, in paper mm.
  constexpr double kWritingError = 0.002;
  return std::max(options.fit_tolerance - kWritingError, 0.5 * options.fit_tolerance);
}

}  // namespace burin
