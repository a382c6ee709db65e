#include <burin/annotate/symbols.h>
#include <burin/arrange/arrange.h>
#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/converters/values.h>

#include "feature_rows.h"
#include "note_option.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace burin::detail {
namespace {

using Mark = LeaderTarget::Mark;

constexpr std::array kMarks{"auto", "dot", "arrow", "none"};

/// Text that may be empty.
Json words(const char* what) { return {{"description", what}, {"type", "string"}}; }

/// A point, or a part, or the like; or several of them.
bool is_list(const Json& value) {
  return value.is_array() && !(value.size() == 3 && value[0].is_number());
}

Vec2 read_place(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_array() || value.size() != 2) {
    in.fail(path, "\"place\" is [x, y], mm from the lower left corner of the sheet");
  }
  constexpr const char* kRange = "mm of the sheet";
  return {in.within(value[0], path + "/0", -1e4, 1e4, kRange),
          in.within(value[1], path + "/1", -1e4, 1e4, kRange)};
}

std::vector<KeyRow<DimensionRow>> own_rows() {
  return {
      {.name = "at",
       .schema = one_or_list_of(target_schema()),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DimensionRow& to) {
             if (!is_list(value)) {
               to.of = {read_target(in, value, path)};
               return;
             }
             if (value.empty()) in.fail(path, "names nothing that the note points at");
             for (std::size_t i = 0; i < value.size(); ++i) {
               to.of.push_back(read_target(in, value[i], fmt::format("{}/{}", path, i)));
             }
           },
       .write =
           [](const DimensionRow& from) {
             Json list = Json::array();
             for (const FeatureRow& one : from.of) list.push_back(write_feature(one));
             if (list.empty()) return Json();
             return list.size() == 1 ? list[0] : list;
           }},
      {.name = "text",
       .schema =
           words("what is written, lines parted by \\n; {part.name}, {item}, {length}, {area}, "
                 "{diameter}, {radius} and {volume} are of the first thing it points at"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  DimensionRow& to) { to.text = value == Json("") ? "" : in.text(value, path); },
       .write = [](const DimensionRow& from) { return Json(from.text); },
       .missing = "a note has \"{}\"; \"\" is none"},
      {.name = "frame",
       .schema = flag("a frame about the text"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  DimensionRow& to) { to.framed = in.flag(value, path); },
       .write = [](const DimensionRow& from) { return from.framed ? Json(true) : Json(); }},
      {.name = "mark",
       .schema =
           words_schema("the end of its leaders (default: a dot where there is space)", kMarks),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DimensionRow& to) {
             to.mark = static_cast<Mark>(word_of(in, value, path, kMarks));
           },
       .write =
           [](const DimensionRow& from) {
             return from.mark == Mark::Found ? Json()
                                             : Json(kMarks[static_cast<std::size_t>(from.mark)]);
           }},
      {.name = "place",
       .schema = {{"description",
                   "[x, y], its lower left corner, mm from that of the sheet (default: beside the "
                   "drawing, where there is space)"},
                  {"type", "array"},
                  {"items", {{"type", "number"}}},
                  {"minItems", 2},
                  {"maxItems", 2}},
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  DimensionRow& to) { to.at_sheet = read_place(in, value, path); },
       .write =
           [](const DimensionRow& from) {
             return from.at_sheet ? Json{from.at_sheet->x, from.at_sheet->y} : Json();
           }},
  };
}

std::vector<std::string> symbol_names() {
  std::vector<std::string> names;
  for (const SymbolKind& kind : symbol_kinds()) names.emplace_back(kind.name);
  return names;
}

KeyRow<DimensionRow> symbol_row() {
  return {
      .name = "symbol",
      .schema = {{"description", "what is drawn about or beside the text"},
                 {"enum", symbol_names()}},
      .read =
          [](const KeyedFile& in, const Json& value, const std::string& path, DimensionRow& to) {
            to.symbol = in.text(value, path);
            if (find_symbol(to.symbol)) return;
            in.fail(path, fmt::format("\"symbol\" takes {}, not {}",
                                      fmt::join(symbol_names(), ", "), to.symbol));
          },
      .write =
          [](const DimensionRow& from) {
            return from.symbol.empty() ? Json() : Json(from.symbol);
          }};
}

/// "weld_joint" of the option "joint" of "weld".
KeyRow<DimensionRow> symbol_option_row(const std::string& symbol, const DeclaredOption& declared) {
  Json schema = Json::parse(value_schema(declared.option));
  schema["description"] = declared.option.meaning;
  return {.name = symbol + "_" + declared.option.name,
          .schema = std::move(schema),
          .read =
              [symbol, declared](const KeyedFile& in, const Json& value, const std::string& path,
                                 DimensionRow& to) {
                const auto given = parse_value(declared.option, option_text(value));
                if (!given) {
                  in.fail(path,
                          fmt::format("\"{}_{}\" takes {}, not {}", symbol, declared.option.name,
                                      takes_text(declared.option), value.dump()));
                }
                set_value(to.symbol_values, symbol, declared, *given);
              },
          .write =
              [symbol, declared](const DimensionRow& from) {
                const OptionValue value = value_of(from.symbol_values, symbol, declared);
                if (value == declared.fallback) return Json();
                return written_value({.option = declared.option, .group = {}},
                                     value_text(declared.option, value));
              }};
}

std::vector<KeyRow<DimensionRow>> symbol_rows() {
  std::vector<KeyRow<DimensionRow>> rows{symbol_row()};
  for (const SymbolKind& kind : symbol_kinds()) {
    for (const DeclaredOption& declared : kind.options) {
      rows.push_back(symbol_option_row(std::string(kind.name), declared));
    }
  }
  return rows;
}

/// Made anew when plug-ins have added symbols.
const std::vector<KeyRow<DimensionRow>>& note_key_rows() {
  static MadeOfCatalogues<std::vector<KeyRow<DimensionRow>>> table;
  return table.get([] {
    std::vector<KeyRow<DimensionRow>> all = own_rows();
    std::ranges::move(symbol_rows(), std::back_inserter(all));
    std::ranges::move(number_rows(), std::back_inserter(all));
    return all;
  });
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

DimensionRow read_note(const KeyedFile& in, const Json& value, const std::string& path) {
  if (value.is_string()) {
    const std::string given = in.text(value, path);
    in.check(draw_rows(), "note", {given}, path, "notes");
    DimensionRow row = note_option("notes", given);
    row.place = in.place(path);
    return row;
  }
  DimensionRow start;
  start.kind = DimensionRow::Kind::Note;
  DimensionRow row = read_object(note_key_rows(), in, value, path, start);
  if (row.of.empty() && !row.at_sheet) {
    in.fail(path, "a note has \"at\", what it points at, or \"place\", mm of the sheet");
  }
  if (is_blank(row.text) && row.symbol.empty()) {
    in.fail(path + "/text", "a note without words has a \"symbol\"");
  }
  if (row.framed && !row.symbol.empty()) {
    in.fail(path, "\"frame\" is for words alone: leave it out beside \"symbol\"");
  }
  for (const auto& [name, ignored] : row.symbol_values.changed) {
    const std::string symbol = name.substr(0, name.find('.'));
    if (symbol == row.symbol) continue;
    in.fail(path, fmt::format("\"{}_{}\" is for the symbol {}", symbol,
                              name.substr(symbol.size() + 1), symbol));
  }
  check_braces(in, row.text, path + "/text", note_values(), known_note_values() + " are known");
  row.place = in.place(path);
  return row;
}

}  // namespace

std::string known_note_values() { return fmt::format("{{{}}}", fmt::join(note_values(), "}, {")); }

DimensionRow note_of(const std::string& spelled, const std::string& text) {
  if (const std::optional<std::string> name = unknown_brace(text, note_values())) {
    throw UsageError(
        fmt::format("{}: {{{}}} is not known: {} are", spelled, *name, known_note_values()));
  }
  DimensionRow row;
  row.kind = DimensionRow::Kind::Note;
  row.text = text;
  return row;
}

DimensionRow note_option(const std::string& spelled, const std::string& text) {
  // A selector may have one: @color=#ff0000.
  const std::size_t equals = text.find('=', text.starts_with('@') ? text.find('=') + 1 : 0);
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    refuse_value(spelled, "NAME=TEXT or X,Y,Z=TEXT, as 'nut*=M6, 8 Nm'", text);
  }
  DimensionRow row = note_of(spelled, text.substr(equals + 1));
  row.place = spelled + ": ";
  FeatureRow& at = row.of.emplace_back();
  const std::string what = text.substr(0, equals);
  double numbers[3];
  if (parse_list(what, numbers)) {
    at.at = {numbers[0], numbers[1], numbers[2]};
  } else {
    at.kind = FeatureRow::Kind::Part;
    at.part = what;
  }
  for (std::size_t n = row.text.find("\\n"); n != std::string::npos; n = row.text.find("\\n", n)) {
    row.text.replace(n, 2, "\n");
  }
  if (is_blank(row.text)) refuse_value(spelled, "words behind the =", text);
  return row;
}

std::vector<RequestRow<Draft>> note_rows() {
  return {
      {{.option = {.name = "note",
                   .meaning = "write words beside the drawing, with a leader to a part, or to the "
                              "face next to a point of the model; \\n begins a line; {part.name}, "
                              "{item}, {volume} ... are its own; repeatable; looks: style keys "
                              "dimension.*",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME|X,Y,Z=TEXT",
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"notes", "text", "label", "labels", "annotation", "annotations", "leader",
                 "leaders", "comment", "caption", "words", "remark"}},
       [](Draft& d, const Asked& a) {
         for (const std::string& text : a.texts)
           d.plan.note_rows.push_back(note_option(a.spelled, text));
       }},
  };
}

void take_notes(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  in.check_array(value, path);
  out.request.notes.clear();
  for_rows(in, value, path, [&](const Json& row, const std::string& at) {
    out.request.notes.push_back(read_note(in, row, at));
  });
}

Json notes_schema() {
  Json object = object_schema(note_key_rows());
  object["anyOf"] = either({"at", "place"});
  Json list = list_of({{"anyOf", {text("parts and words, as nut*=M6"), std::move(object)}}});
  list["maxItems"] = kMostRows;
  return list;
}

Json write_notes(const DrawRequest& request) {
  Json list = Json::array();
  for (const DimensionRow& row : request.notes) list.push_back(write_object(note_key_rows(), row));
  for (const std::string& text : given_texts(request.options, "note")) list.push_back(text);
  return list;
}

}  // namespace burin::detail
