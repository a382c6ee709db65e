#include "read_options.h"

#include <burin/base/ascii.h>
#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/plugin/sources.h>

#include "encoding.h"
#include "readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace detail {
namespace {

constexpr const char* kLook = "The look";
constexpr unsigned kAllFamilies = ~0U;

std::vector<ReadRow> first_rows() {
  return {
      {{{.option = {.name = "input_format",
                    .meaning = "format of standard input (-) and of files without a known suffix: "
                               "stl, obj, step, .. ; contents that show their format come first",
                    .takes = FreeText{}},
         .group = kFiles,
         .label = "FORMAT"},
        [](ReadOptions& o, const Asked& a) {
          o.input_format = lowered(a.text());
          if (o.input_format.starts_with('.')) o.input_format.erase(0, 1);
          if (o.input_format == "scad" || o.input_format == "csg") {
            throw UsageError(a.spelled +
                             ": OpenSCAD's programs are read from files, as they name others; save "
                             "it as a file with the suffix .scad");
          }
          if (!is_read_suffix("." + o.input_format)) {
            const std::string needed = needed_for("x." + o.input_format);
            if (!needed.empty()) throw UsageError(a.spelled + ": " + needed);
            refuse_value(a.spelled, "a suffix of a format that is read, such as stl or step",
                         a.text());
          }
        }},
       kAllFamilies,
       "standard input and files without a known suffix"},
  };
}

std::vector<ReadRow> shared_rows() {
  return {
      {{{.option = {.name = "encoding",
                    .meaning = "encoding of the names, for files that do not state it, such as "
                               "GB18030, SHIFT_JIS, "
                               "EUC-KR or WINDOWS-1252 (default: guessed from the names)",
                    .takes = FreeText{}},
         .group = kFiles,
         .label = "NAME"},
        [](ReadOptions& o, const Asked& a) {
          check_encoding(a.spelled, a.text());
          o.encoding = a.text();
        }},
       CadFiles | Meshes | Splines,
       "STEP, IGES, OBJ, STL and IRIT files"},
      {{{.option = {.name = "pmi",
                    .meaning = "draw the dimensions, tolerances, datums and notes that a STEP file "
                               "carries (AP242); burin info lists them",
                    .takes = Switch{}},
         .group = kLook,
         .also = {"annotations", "gd&t", "gdt", "tolerances", "mbd", "fcf", "datums"}},
        [](ReadOptions& o, const Asked& a) { o.pmi = std::get<bool>(a.value); }},
       CadFiles,
       "STEP files"},
      {{{.option =
             {.name = "heal",
              .meaning =
                  "draw facets of meshes as the round surfaces that they approximate (default for "
                  "OpenSCAD files)",
              .takes = Switch{}},
         .group = kLook,
         .negated = "draw facets as they are",
         .also = {"recognise", "recognize", "fit surfaces", "smooth facets", "reverse engineer"}},
        [](ReadOptions& o, const Asked& a) { o.heal = std::get<bool>(a.value); }},
       Meshes | OpenscadFiles,
       "meshes and OpenSCAD files"},
  };
}

std::vector<ReadRow> level_rows() {
  constexpr double kMost = std::numeric_limits<double>::max();
  return {
      {{{.option = {.name = "bounds",
                    .meaning =
                        "domain x0,y0,z0,x1,y1,z1 of functions and volumes, in model mm (default: "
                        "their own bounds)",
                    .takes = FreeText{}},
         .group = kData,
         .label = "X0,..,Z1",
         .python = "Sequence[float]",
         .also = {"domain", "bounding box", "bbox", "region"}},
        [](ReadOptions& o, const Asked& a) { o.bounds = box_option(a.spelled, a.text()); }},
       Functions | Volumes | Splines,
       "functions, volumes and trivariate splines"},
      {{{.option = {.name = "mesher",
                    .meaning =
                        "triangles of functions: even and fast, or graded by curvature (default "
                        "auto); lines are exact with either",
                    .takes = WordList{{"auto", "nets", "delaunay"}}},
         .group = kData,
         .label = "auto|nets|delaunay"},
        [](ReadOptions& o, const Asked& a) {
          o.mesher = static_cast<Mesher>(std::get<std::uint64_t>(a.value));
          o.volume.mesher = o.mesher;
        }},
       Functions | Volumes,
       "functions and volumes"},
      {{{.option =
             {.name = "iso",
              .meaning =
                  "the surface of a volume is where its data has this value; burin info lists "
                  "the range (no default; trivariate splines: 0)",
              .takes = NumberRange{-kMost, kMost},
              .phrase = "a number"},
         .group = kData,
         .label = "LEVEL",
         .also = {"isovalue", "level", "threshold", "iso value", "isosurface", "iso level"}},
        [](ReadOptions& o, const Asked& a) { o.volume.level = std::get<double>(a.value); }},
       Volumes | Splines,
       "volumes and trivariate splines"},
      {{{.option = {.name = "inside",
                    .meaning = "values that are inside (default above; trivariate splines: below)",
                    .takes = WordList{{"above", "below"}}},
         .group = kData,
         .label = "above|below"},
        [](ReadOptions& o, const Asked& a) {
          o.volume.inside_above = std::get<std::uint64_t>(a.value) == 0;
        }},
       Volumes | Splines,
       "volumes and trivariate splines"},
  };
}

/// The word that help writes after a name; switches have none.
std::string label_of(const Option& option) {
  if (std::holds_alternative<Switch>(option.takes)) return {};
  return std::holds_alternative<NumberRange>(option.takes) ||
                 std::holds_alternative<WholeRange>(option.takes)
             ? "NUMBER"
             : "VALUE";
}

/// "gyroids", "cell-size": "gyroids_cell_size".
std::string joined_name(std::string_view row, const std::string& option) {
  std::string name = std::string(row) + "_" + option;
  std::ranges::replace(name, '-', '_');
  return name;
}

/// The options of what plug-ins added. One whose name is taken keeps its fallback.
template <class Kind>
void append_added(std::span<const Kind> kinds, const char* what, std::vector<ReadRow>& rows) {
  for (const Kind& kind : kinds) {
    for (const DeclaredOption& declared : kind.options) {
      Option option = declared.option;
      option.name = joined_name(kind.name, option.name);
      const std::string name = option.name, row(kind.name);
      const auto same = [&](const ReadRow& r) { return r.row.name() == name; };
      if (std::ranges::any_of(rows, same)) continue;
      option.meaning += fmt::format(" (default {})", value_text(option, declared.fallback));
      const std::string label = label_of(option);
      rows.push_back({{{.option = std::move(option), .group = kFiles, .label = label},
                       [declared, row](ReadOptions& o, const Asked& a) {
                         set_value(o.declared, row, declared, a.value);
                       }},
                      Added,
                      fmt::format("the {} '{}'", what, row),
                      row});
    }
  }
}

/// The options of readers: those about files, or the others.
void append_own(bool files, std::vector<ReadRow>& rows) {
  for (const Reader* reader : own_readers()) {
    if (reader->options == nullptr) continue;
    for (ReadRow& row : reader->options()) {
      if ((row.row.about.group == kFiles) == files) rows.push_back(std::move(row));
    }
  }
}

std::vector<ReadRow> make_read_rows() {
  std::vector<ReadRow> rows = first_rows();
  append_own(true, rows);
  for (const auto& group : {shared_rows(), level_rows()}) {
    rows.insert(rows.end(), group.begin(), group.end());
  }
  append_own(false, rows);
  // What none of the readers looks at that Burin was built with.
  unsigned there = 0;
  for (const Reader* reader : own_readers()) there |= reader->family;
  std::erase_if(rows, [&](const ReadRow& row) { return (row.families & there) == 0; });
  append_added(plugin::readers(), "reader", rows);
  append_added(plugin::forms(), "form", rows);
  return rows;
}

const std::vector<ReadRow>& read_rows() {
  static MadeOfCatalogues<std::vector<ReadRow>> all;
  return all.get(make_read_rows);
}

}  // namespace

const ReadRow* find_read_row(std::string_view name) {
  const auto found =
      std::ranges::find_if(read_rows(), [&](const ReadRow& r) { return r.row.name() == name; });
  return found == read_rows().end() ? nullptr : &*found;
}

}  // namespace detail

const std::vector<RequestRow<ReadOptions>>& read_option_rows() {
  static MadeOfCatalogues<std::vector<RequestRow<ReadOptions>>> rows;
  return rows.get([] {
    std::vector<RequestRow<ReadOptions>> out;
    for (const detail::ReadRow& row : detail::read_rows()) out.push_back(row.row);
    return out;
  });
}

ReadOptions make_read_options(const Request& request, Spelling spelling) {
  ReadOptions read;
  apply(read_option_rows(), request, spelling, read);
  for (const auto& row : read_option_rows()) {
    const std::vector<std::string>& given = given_texts(request, row.name());
    if (given.empty()) continue;
    // The switch that turns it off is an option of its own.
    const bool off =
        spelling == Spelling::Options && !row.about.negated.empty() && given.back() == "false";
    read.given.push_back({row.name(), called(off ? "no_" + row.name() : row.name(), spelling)});
  }
  return read;
}

}  // namespace burin
