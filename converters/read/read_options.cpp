#include "read_options.h"

#include <burin/base/ascii.h>
#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/values.h>
#include <burin/plugin/sources.h>

#include "encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace detail {
namespace {

constexpr const char* kFiles = "Files";
constexpr const char* kLook = "The look";
constexpr const char* kData = "Functions and volumes";
constexpr unsigned kAllFamilies = ~0U;
constexpr double kWeek = 604'800;  // seconds
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 50;

using Set = std::function<void(ReadOptions&, const Asked&)>;

template <class M>
Set number_to(M member) {
  return [member](ReadOptions& o, const Asked& a) { member(o) = std::get<double>(a.value); };
}

std::vector<ReadRow> file_rows() {
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
            refuse_value(a.spelled, "a suffix of a format that is read, such as stl or step",
                         a.text());
          }
        }},
       kAllFamilies,
       "standard input and files without a known suffix"},
      {{{.option =
             {.name = "define",
              .meaning =
                  "define a variable of OpenSCAD files; repeatable; a text keeps its quotes: -D "
                  "'label=\"A\"'",
              .takes = FreeText{}},
         .group = kFiles,
         .label = "NAME=VALUE",
         .many = true,
         .letter = 'D',
         .python = "Mapping[str, Any] | Sequence[str]",
         .also = {"variable", "var", "d", "parameter", "parameters", "params", "param",
                  "set variable", "arg"}},
        [](ReadOptions& o, const Asked& a) {
          check_openscad_defines(a.texts);
          o.defines = a.texts;
        }},
       OpenscadFiles,
       "OpenSCAD files"},
      {{{.option = {.name = "openscad_timeout",
                    .meaning = "end OpenSCAD after so long (default 300)",
                    .takes = NumberRange{0.001, kWeek, "s"},
                    .phrase = "seconds over 0"},
         .group = kFiles,
         .label = "SECONDS"},
        number_to([](ReadOptions& o) -> double& { return o.openscad_timeout; })},
       OpenscadFiles,
       "OpenSCAD files"},
      {{{.option = {.name = "csg",
                    .meaning =
                        "who makes solids of an OpenSCAD program's tree: auto takes OpenSCAD where "
                        "Burin cannot, which makes one part of it (default auto)",
                    .takes = WordList{{"auto", "burin", "openscad"}}},
         .group = kFiles,
         .label = "auto|burin|openscad"},
        [](ReadOptions& o, const Asked& a) {
          o.csg = static_cast<CsgBy>(std::get<std::uint64_t>(a.value));
        }},
       OpenscadFiles,
       "OpenSCAD files"},
      {{{.option = {.name = "as_",
                    .meaning =
                        "make solids of an OpenSCAD program's tree, or implicit functions, which "
                        "know the true surfaces of its primitives alone (default solid)",
                    .takes = WordList{{"solid", "implicit"}}},
         .group = kFiles,
         .label = "solid|implicit"},
        [](ReadOptions& o, const Asked& a) {
          o.as_implicit = std::get<std::uint64_t>(a.value) == 1;
        }},
       OpenscadFiles,
       "OpenSCAD files"},
      {{{.option =
             {.name = "object",
              .meaning =
                  "draw this object of FreeCAD documents, hidden or not; repeatable (default: "
                  "all that are visible)",
              .takes = FreeText{}},
         .group = kFiles,
         .label = "NAME|LABEL",
         .many = true,
         .python = "str | Sequence[str]",
         .also = {"body name", "node", "feature", "label name"}},
        [](ReadOptions& o, const Asked& a) { o.objects = a.texts; }},
       FreecadFiles,
       "FreeCAD documents"},
      {{{.option = {.name = "recompute",
                    .meaning = "let FreeCAD recompute the document first (the file stays as it is)",
                    .takes = Switch{}},
         .group = kFiles},
        [](ReadOptions& o, const Asked& a) { o.recompute = std::get<bool>(a.value); }},
       FreecadFiles,
       "FreeCAD documents"},
      {{{.option = {.name = "freecad_timeout",
                    .meaning = "end FreeCAD after so long (default 300)",
                    .takes = NumberRange{0.001, kWeek, "s"},
                    .phrase = "seconds over 0"},
         .group = kFiles,
         .label = "SECONDS"},
        number_to([](ReadOptions& o) -> double& { return o.freecad_timeout; })},
       FreecadFiles,
       "FreeCAD documents that are recomputed"},
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

std::vector<ReadRow> volume_rows() {
  return {
      {{{.option =
             {.name = "smooth",
              .meaning =
                  "standard deviation of a Gaussian that a volume is smoothed with (default 0)",
              .takes = NumberRange{0, 100, "samples"},
              .phrase = "a standard deviation of 0 to 100 samples"},
         .group = kData,
         .label = "SAMPLES",
         .also = {"blur", "gauss", "sigma", "denoise"}},
        number_to([](ReadOptions& o) -> double& { return o.volume.smoothing; })},
       Volumes,
       "volumes"},
      {{{.option =
             {.name = "specks",
              .meaning =
                  "components of a volume smaller than this share of the largest one are left "
                  "out (default 0.02)",
              .takes = NumberRange{0, 0.99},
              .phrase = "a share from 0 to 0.99 of the largest component's size"},
         .group = kData,
         .label = "SHARE"},
        number_to([](ReadOptions& o) -> double& { return o.volume.smallest_part; })},
       Volumes,
       "volumes"},
      {{{.option = {.name = "volume_degree",
                    .meaning = "degree of the spline of a volume (default 3)",
                    .takes = WholeRange{2, 3},
                    .phrase = "2 or 3"},
         .group = kData,
         .label = "2|3"},
        [](ReadOptions& o, const Asked& a) {
          o.volume.degree = static_cast<int>(std::get<std::uint64_t>(a.value));
        }},
       Volumes,
       "volumes"},
      {{{.option = {.name = "interpolate",
                    .meaning =
                        "take the values of the samples exactly; without it they are the spline's "
                        "coefficients, a little smoother",
                    .takes = Switch{}},
         .group = kData},
        [](ReadOptions& o, const Asked& a) { o.volume.interpolate = std::get<bool>(a.value); }},
       Volumes,
       "volumes"},
      {{{.option = {.name = "raw",
                    .meaning =
                        "what a raw file holds: NXxNYxNZ[:TYPE[:DX,DY,DZ]], TYPE u8 i8 u16 .. f64, "
                        "u16be .. for big-endian (default u8:1,1,1)",
                    .takes = FreeText{}},
         .group = kData,
         .label = "NXxNYxNZ[..]"},
        [](ReadOptions& o, const Asked& a) { o.volume.raw = parse_raw_layout(a.text()); }},
       Volumes,
       "files of raw samples, which have no header"},
      {{{.option = {.name = "raw_skip",
                    .meaning = "bytes before the first sample of a raw file (default 0)",
                    .takes = WholeRange{0, kMostBytes},
                    .phrase = "a number of bytes"},
         .group = kData,
         .label = "BYTES"},
        [](ReadOptions& o, const Asked& a) {
          if (!o.volume.raw) throw UsageError(a.spelled + " goes with `raw`");
          o.volume.raw->skip = static_cast<std::int64_t>(std::get<std::uint64_t>(a.value));
        }},
       Volumes,
       "files of raw samples"},
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
void append_brought(std::span<const Kind> kinds, const char* what, std::vector<ReadRow>& rows) {
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
                      Brought,
                      fmt::format("the {} '{}'", what, row),
                      row});
    }
  }
}

std::vector<ReadRow> make_read_rows() {
  std::vector<ReadRow> rows;
  for (const auto& group : {file_rows(), level_rows(), volume_rows()}) {
    rows.insert(rows.end(), group.begin(), group.end());
  }
  append_brought(plugin::readers(), "reader", rows);
  append_brought(plugin::forms(), "form", rows);
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
