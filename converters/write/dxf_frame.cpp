#include "dxf_frame.h"

#include <burin/base/ascii.h>
#include <burin/base/version.h>
#include <burin/drawing/color.h>

#include "dxf_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace burin::dxf {
namespace {

void begin_section(Groups& out, std::string_view name) { out.text(0, "SECTION").text(2, name); }
void end_section(Groups& out) { out.text(0, "ENDSEC"); }

void append_header(Groups& out, const Frame& f) {
  begin_section(out, "HEADER");
  out.text(9, "$ACADVER").text(1, "AC1015");
  out.text(9, "$DWGCODEPAGE").text(3, "ANSI_1252");
  out.text(9, "$INSBASE").point(10, Vec3(0));
  out.text(9, "$EXTMIN").point(10, Vec3(f.low, 0));
  out.text(9, "$EXTMAX").point(10, Vec3(f.high, 0));
  out.text(9, "$LIMMIN").point(10, Vec2(0));
  out.text(9, "$LIMMAX").point(10, f.sheet);
  out.text(9, "$LTSCALE").real(40, 1);
  out.text(9, "$CLAYER").text(8, "0");
  out.text(9, "$CELTYPE").text(6, "ByLayer");
  out.text(9, "$CELWEIGHT").whole(370, -1);
  out.text(9, "$LWDISPLAY").whole(290, 1);
  out.text(9, "$LUNITS").whole(70, 2);
  out.text(9, "$LUPREC").whole(70, 4);
  out.text(9, "$MEASUREMENT").whole(70, 1);
  out.text(9, "$INSUNITS").whole(70, 4);
  out.text(9, "$PLINEGEN").whole(70, 1);
  out.text(9, "$HANDSEED").handle(5, f.next_handle);
  end_section(out);
  begin_section(out, "CLASSES");
  end_section(out);
}

void begin_table(Groups& out, std::string_view name, Fixed handle, std::size_t rows) {
  out.text(0, "TABLE").text(2, name).handle(5, handle).whole(330, 0);
  out.text(100, "AcDbSymbolTable").whole(70, static_cast<std::int64_t>(rows));
}
void end_table(Groups& out) { out.text(0, "ENDTAB"); }

/// The head of a row of a table.
Groups& row(Groups& out, std::string_view kind, std::uint64_t handle, Fixed table,
            std::string_view type) {
  return out.text(0, kind)
      .handle(5, handle)
      .handle(330, table)
      .text(100, "AcDbSymbolTableRecord")
      .text(100, type);
}
Groups& row(Groups& out, std::string_view kind, Fixed handle, Fixed table, std::string_view type) {
  return row(out, kind, static_cast<std::uint64_t>(handle), table, type);
}

void append_vport(Groups& out, const Frame& f) {
  begin_table(out, "VPORT", Fixed::VportTable, 1);
  row(out, "VPORT", Fixed::Vport, Fixed::VportTable, "AcDbViewportTableRecord");
  out.text(2, "*Active").whole(70, 0).point(10, Vec2(0)).point(11, Vec2(1));
  out.point(12, 0.5 * f.sheet).point(13, Vec2(0)).point(14, Vec2(10)).point(15, Vec2(10));
  out.point(16, Vec3(0, 0, 1)).point(17, Vec3(0));
  out.real(40, f.sheet.y).real(41, f.sheet.x / f.sheet.y).real(42, 50).real(43, 0).real(44, 0);
  out.real(50, 0).real(51, 0).whole(71, 0).whole(72, 1000).whole(73, 1).whole(74, 3);
  out.whole(75, 0).whole(76, 0).whole(77, 0).whole(78, 0);
  end_table(out);
}

void append_linetypes(Groups& out, const Frame& f) {
  begin_table(out, "LTYPE", Fixed::LtypeTable, 6);
  const auto plain = [&](Fixed handle, std::string_view name, std::string_view description) {
    row(out, "LTYPE", handle, Fixed::LtypeTable, "AcDbLinetypeTableRecord");
    out.text(2, name).whole(70, 0).text(3, description).whole(72, 65).whole(73, 0).real(40, 0);
  };
  plain(Fixed::ByBlock, "ByBlock", "");
  plain(Fixed::ByLayer, "ByLayer", "");
  plain(Fixed::Continuous, kContinuous, "Solid line");
  const auto broken = [&](Fixed handle, std::string_view name, std::string_view description,
                          const std::vector<double>& lengths) {
    row(out, "LTYPE", handle, Fixed::LtypeTable, "AcDbLinetypeTableRecord");
    out.text(2, name).whole(70, 0).text(3, description).whole(72, 65);
    out.whole(73, static_cast<std::int64_t>(lengths.size()));
    out.real(40, std::accumulate(lengths.begin(), lengths.end(), 0.0));
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      out.real(49, i % 2 == 0 ? lengths[i] : -lengths[i]).whole(74, 0);
    }
  };
  broken(Fixed::Dashed, kDashed, "ISO 128 dashed __ __ __", f.dashes);
  broken(Fixed::DashDot, kDashDot, "ISO 128 dash dot __ . __ . __", f.dash_dots);
  broken(Fixed::LongDashDot, kLongDashDot, "ISO 128 long dash dot ____ . ____ . ____",
         f.long_dash_dots);
  end_table(out);
}

void append_layers(Groups& out, const std::vector<LayerRow>& layers) {
  begin_table(out, "LAYER", Fixed::LayerTable, layers.size() + 1);
  const auto one = [&](std::uint64_t handle, const LayerRow& layer) {
    row(out, "LAYER", handle, Fixed::LayerTable, "AcDbLayerTableRecord");
    out.text(2, layer.name).whole(70, 0).whole(62, layer.color);
    out.text(6, layer.linetype).whole(370, layer.weight);
    out.handle(390, Fixed::Placeholder);
  };
  one(static_cast<std::uint64_t>(Fixed::LayerZero), {"0", kContinuous, 25});
  auto handle = static_cast<std::uint64_t>(Fixed::FirstLayer);
  for (const LayerRow& layer : layers) one(handle++, layer);
  end_table(out);
}

void append_other_tables(Groups& out) {
  begin_table(out, "STYLE", Fixed::StyleTable, 1);
  row(out, "STYLE", Fixed::Style, Fixed::StyleTable, "AcDbTextStyleTableRecord");
  out.text(2, "Standard").whole(70, 0).real(40, 0).real(41, 1).real(50, 0).whole(71, 0);
  out.real(42, 2.5).text(3, "txt").text(4, "");
  end_table(out);
  begin_table(out, "VIEW", Fixed::ViewTable, 0);
  end_table(out);
  begin_table(out, "UCS", Fixed::UcsTable, 0);
  end_table(out);
  begin_table(out, "APPID", Fixed::AppidTable, 2);
  row(out, "APPID", Fixed::Acad, Fixed::AppidTable, "AcDbRegAppTableRecord");
  out.text(2, "ACAD").whole(70, 0);
  row(out, "APPID", Fixed::Burin, Fixed::AppidTable, "AcDbRegAppTableRecord");
  out.text(2, kApplication).whole(70, 0);
  end_table(out);
  begin_table(out, "DIMSTYLE", Fixed::DimstyleTable, 1);
  out.text(100, "AcDbDimStyleTable").whole(71, 0);
  out.text(0, "DIMSTYLE").handle(105, Fixed::Dimstyle).handle(330, Fixed::DimstyleTable);
  out.text(100, "AcDbSymbolTableRecord").text(100, "AcDbDimStyleTableRecord");
  out.text(2, "Standard").whole(70, 0);
  end_table(out);
}

void append_blocks(Groups& out) {
  struct Space {
    const char* name;
    Fixed record, begin, end, layout;
    bool paper;
  };
  const Space spaces[] = {{"*Model_Space", Fixed::ModelSpace, Fixed::ModelBlock, Fixed::ModelEnd,
                           Fixed::ModelLayout, false},
                          {"*Paper_Space", Fixed::PaperSpace, Fixed::PaperBlock, Fixed::PaperEnd,
                           Fixed::PaperLayout, true}};
  begin_table(out, "BLOCK_RECORD", Fixed::BlockTable, 2);
  for (const Space& s : spaces) {
    row(out, "BLOCK_RECORD", s.record, Fixed::BlockTable, "AcDbBlockTableRecord");
    out.text(2, s.name).handle(340, s.layout);
  }
  end_table(out);
  end_section(out);
  begin_section(out, "BLOCKS");
  for (const Space& s : spaces) {
    const auto entity = [&](const char* kind, Fixed handle) -> Groups& {
      out.text(0, kind).handle(5, handle).handle(330, s.record).text(100, "AcDbEntity");
      if (s.paper) out.whole(67, 1);
      return out.text(8, "0");
    };
    entity("BLOCK", s.begin).text(100, "AcDbBlockBegin").text(2, s.name).whole(70, 0);
    out.point(10, Vec3(0)).text(3, s.name).text(1, "");
    entity("ENDBLK", s.end).text(100, "AcDbBlockEnd");
  }
  end_section(out);
}

struct Entry {
  const char* name;
  Fixed handle;
};

void append_dictionary(Groups& out, Fixed handle, Fixed owner, const std::vector<Entry>& entries) {
  out.text(0, "DICTIONARY").handle(5, handle);
  if (handle == Fixed::Root) {
    out.whole(330, 0);
  } else {
    out.handle(330, owner);
  }
  out.text(100, "AcDbDictionary").whole(281, 1);
  for (const Entry& e : entries) out.text(3, e.name).handle(350, e.handle);
}

void append_layout(Groups& out, Fixed handle, const char* name, int order, Fixed block,
                   const Frame& f) {
  const bool model = order == 0;
  out.text(0, "LAYOUT").handle(5, handle).handle(330, Fixed::Layouts);
  out.text(100, "AcDbPlotSettings").text(1, "").text(2, "none_device").text(4, "").text(6, "");
  for (int code = 40; code < 44; ++code) out.real(code, 0);
  out.real(44, f.sheet.x).real(45, f.sheet.y).real(46, 0).real(47, 0).real(48, 0).real(49, 0);
  out.real(140, 0).real(141, 0).real(142, 1).real(143, 1);
  out.whole(70, model ? 1712 : 688).whole(72, 1).whole(73, 0).whole(74, 5).text(7, "");
  out.whole(75, 16).real(147, 1).real(148, 0).real(149, 0);
  out.text(100, "AcDbLayout").text(1, name).whole(70, 1).whole(71, order);
  out.point(10, Vec2(0)).point(11, f.sheet).point(12, Vec3(0));
  out.point(14, Vec3(f.low, 0)).point(15, Vec3(f.high, 0)).real(146, 0);
  out.point(13, Vec3(0)).point(16, Vec3(1, 0, 0)).point(17, Vec3(0, 1, 0)).whole(76, 0);
  out.handle(330, block);
}

}  // namespace

int nearest_of_all_colors(const Rgb& color) {
  constexpr int kFirst = 10, kHues = 24, kFirstGray = 250;
  constexpr std::array<double, 5> kBright{255, 165, 127, 76, 38};
  constexpr std::array<double, 6> kGrays{51, 91, 132, 173, 214, 255};
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](int number, const std::array<double, 3>& known) {
    double off = 0;
    for (std::size_t c = 0; c < 3; ++c) off += (color[c] - known[c]) * (color[c] - known[c]);
    if (off >= least) return;
    least = off;
    best = number;
  };
  // A dark red may be nearer to a dark grey than any grey is.
  const int hues = is_grey(color) ? 0 : kHues;
  for (int hue = 0; hue < hues; ++hue) {
    std::array<double, 3> pure{};
    for (std::size_t c = 0; c < 3; ++c) {
      // Steps of 15 degrees from the hue of which this is the pure one, both ways.
      const int away = std::abs((hue - 8 * static_cast<int>(c) + 36) % kHues - 12);
      pure[c] = std::clamp((8 - away) / 4.0, 0.0, 1.0);
    }
    for (std::size_t k = 0; k < kBright.size(); ++k) {
      for (int half = 0; half < 2; ++half) {
        std::array<double, 3> known{};
        for (std::size_t c = 0; c < 3; ++c) {
          known[c] = kBright[k] * (half == 0 ? pure[c] : 0.5 + 0.5 * pure[c]);
        }
        look(kFirst + 10 * hue + 2 * static_cast<int>(k) + half, known);
      }
    }
  }
  look(8, {128, 128, 128});
  look(9, {192, 192, 192});
  for (std::size_t k = 0; k < kGrays.size(); ++k) {
    look(kFirstGray + static_cast<int>(k), {kGrays[k], kGrays[k], kGrays[k]});
  }
  return best;
}

int nearest_color(const Rgb& color) {
  // By number; white is 7 as black is, which is what paper makes of it.
  constexpr std::array<std::array<int, 4>, 9> kKnown{{{1, 255, 0, 0},
                                                      {2, 255, 255, 0},
                                                      {3, 0, 255, 0},
                                                      {4, 0, 255, 255},
                                                      {5, 0, 0, 255},
                                                      {6, 255, 0, 255},
                                                      {7, 0, 0, 0},
                                                      {8, 128, 128, 128},
                                                      {9, 192, 192, 192}}};
  // Dark red is red: hue counts, not how bright it is, where there is one.
  const int high = std::max({color[0], color[1], color[2]});
  const int low = std::min({color[0], color[1], color[2]});
  constexpr int kGray = 24;
  const auto level = [&](std::size_t c) {
    return high - low < kGray ? static_cast<double>(color[c])
                              : 255.0 * (color[c] - low) / (high - low);
  };
  int best = 7;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& known : kKnown) {
    double off = 0;
    for (std::size_t c = 0; c < 3; ++c) off += std::pow(level(c) - known[c + 1], 2);
    if (off < least) least = off, best = known[0];
  }
  return best;
}

std::string symbol_name(std::string_view name, const std::vector<LayerRow>& taken) {
  constexpr std::string_view kForbidden = "<>/\\\":;?*|=`,";
  std::string stem;
  for (const char c : name.substr(0, 60)) {
    stem += c >= ' ' && c <= '~' && kForbidden.find(c) == kForbidden.npos ? c : '_';
  }
  if (stem.empty()) stem = "layer";
  // Names differ by more than case.
  std::string unique = stem;
  const auto is_taken = [&](const LayerRow& row) { return equal_but_for_case(unique, row.name); };
  for (int i = 2; unique == "0" || std::any_of(taken.begin(), taken.end(), is_taken); ++i) {
    unique = fmt::format("{}-{}", stem, i);
  }
  return unique;
}

void append_head(Buffer& out, const Frame& frame, const std::vector<LayerRow>& layers) {
  Groups groups(out);
  groups.text(999, fmt::format("burin {}", version()));
  append_header(groups, frame);
  begin_section(groups, "TABLES");
  append_vport(groups, frame);
  append_linetypes(groups, frame);
  append_layers(groups, layers);
  append_other_tables(groups);
  append_blocks(groups);
  begin_section(groups, "ENTITIES");
}

void append_tail(Buffer& buffer, const Frame& frame) {
  Groups out(buffer);
  end_section(out);
  begin_section(out, "OBJECTS");
  append_dictionary(out, Fixed::Root, Fixed::Root,
                    {{"ACAD_GROUP", Fixed::Groups},
                     {"ACAD_LAYOUT", Fixed::Layouts},
                     {"ACAD_MLINESTYLE", Fixed::MlineStyles},
                     {"ACAD_PLOTSETTINGS", Fixed::PlotSettings},
                     {"ACAD_PLOTSTYLENAME", Fixed::PlotStyles}});
  append_dictionary(out, Fixed::Groups, Fixed::Root, {});
  append_dictionary(out, Fixed::Layouts, Fixed::Root,
                    {{"Layout1", Fixed::PaperLayout}, {"Model", Fixed::ModelLayout}});
  append_dictionary(out, Fixed::MlineStyles, Fixed::Root, {{"Standard", Fixed::MlineStyle}});
  append_dictionary(out, Fixed::PlotSettings, Fixed::Root, {});
  out.text(0, "ACDBDICTIONARYWDFLT").handle(5, Fixed::PlotStyles).handle(330, Fixed::Root);
  out.text(100, "AcDbDictionary").whole(281, 1).text(3, "Normal").handle(350, Fixed::Placeholder);
  out.text(100, "AcDbDictionaryWithDefault").handle(340, Fixed::Placeholder);
  out.text(0, "ACDBPLACEHOLDER").handle(5, Fixed::Placeholder).handle(330, Fixed::PlotStyles);
  append_layout(out, Fixed::ModelLayout, "Model", 0, Fixed::ModelSpace, frame);
  append_layout(out, Fixed::PaperLayout, "Layout1", 1, Fixed::PaperSpace, frame);
  out.text(0, "MLINESTYLE").handle(5, Fixed::MlineStyle).handle(330, Fixed::MlineStyles);
  out.text(100, "AcDbMlineStyle").text(2, "Standard").whole(70, 0).text(3, "").whole(62, 256);
  out.real(51, 90).real(52, 90).whole(71, 2);
  for (const double offset : {0.5, -0.5}) out.real(49, offset).whole(62, 256).text(6, "ByLayer");
  end_section(out);
  out.text(0, "EOF");
}

}  // namespace burin::dxf
