#include <burin/annotate/symbols.h>
#include <burin/drawing/font.h>

#include "declared.h"
#include "rows.h"
#include "symbol_check.h"

#include <string>
#include <utility>
#include <vector>

/// What a plug-in knows by name alone.
struct burin_symbol {
  burin::Label label;
  std::string fault;
};

namespace burin::plugin {
namespace {

constexpr auto kSymbolRow = PluginError::Row::Symbol;

/// Whether a piece is taken; the first fault is kept.
bool takes(burin_symbol& symbol, const char* fault) {
  const Label& label = symbol.label;
  if (label.paths.size() + label.areas.size() + label.texts.size() >= kMostSymbolPieces) {
    fault = "has more than 10,000 pieces";
  }
  if (fault != nullptr && symbol.fault.empty()) symbol.fault = fault;
  return fault == nullptr;
}

std::vector<Vec2> points_of(std::size_t count, const double* points) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) out.emplace_back(points[2 * i], points[2 * i + 1]);
  return out;
}

std::int32_t add_line(burin_symbol* symbol, std::size_t count, const double* points, double width,
                      std::int32_t closed) {
  if (!takes(*symbol, line_fault(count, points, width))) return BURIN_FAILED;
  Path path;
  path.kind = LineClass::Frame;
  path.points = points_of(count, points);
  path.width = {width};
  path.closed = closed != 0;
  symbol->label.paths.push_back(std::move(path));
  return BURIN_OK;
}

std::int32_t add_fill(burin_symbol* symbol, std::size_t rings, const std::size_t* counts,
                      const double* points, const char* color) {
  if (!takes(*symbol, fill_fault(rings, counts, points, color))) return BURIN_FAILED;
  Area area;
  area.fill = color;
  for (std::size_t k = 0; k < rings; points += 2 * counts[k++]) {
    area.rings.push_back(points_of(counts[k], points));
  }
  symbol->label.areas.push_back(std::move(area));
  return BURIN_OK;
}

std::int32_t add_text(burin_symbol* symbol, double x, double y, double height, std::int32_t anchor,
                      const char* text) {
  if (!takes(*symbol, text_fault(x, y, height, anchor, text))) return BURIN_FAILED;
  symbol->label.texts.push_back({{x, y}, height, static_cast<TextAnchor>(anchor), text, "note", 0});
  return BURIN_OK;
}

double width_of(const char* text, double height) {
  return text_fault(0, 0, height, 0, text) == nullptr ? text_width(text, height) : 0;
}

constexpr burin_symbol_calls kPieceCalls{add_line, add_fill, add_text, width_of};

Label drawn_symbol(const Source& source, const SymbolRequest& request) {
  const auto options = declared(*source.factory);
  const Values values(values_of(request.values, source.factory->name, options));
  const burin_symbol_request asked{request.text.c_str(), request.pens.height, request.pens.line};
  burin_symbol symbol;
  burin_symbol_box box{};
  burin_error error{};
  const std::int32_t code = source.functions<burin_symbol_1>().draw(
      &asked, values.data(), &kPieceCalls, &symbol, &box, &error);
  if (!symbol.fault.empty()) fail(kSymbolRow, source, symbol.fault);
  check(kSymbolRow, source, code, error);
  if (const char* fault = box_fault(box)) fail(kSymbolRow, source, fault);
  symbol.label.size = {box.width, box.height};
  symbol.label.shoulder = box.shoulder;
  symbol.label.underlined = box.underlined != 0;
  return std::move(symbol.label);
}

}  // namespace

void add_symbol(const Source& source) {
  add(SymbolKind{.name = source.factory->name,
                 .meaning = source.factory->meaning,
                 .draw = [source](const SymbolRequest& r) { return drawn_symbol(source, r); },
                 .options = declared(*source.factory)});
}

}  // namespace burin::plugin
