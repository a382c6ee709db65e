#include <burin/converters/openscad_reader.h>

#include "../readers.h"
#include "all.h"

namespace burin::detail {
namespace {

OpenscadOptions openscad_options(const ReadOptions& o) {
  return {o.defines, o.openscad_timeout, o.csg, o.heal.value_or(true), o.as_implicit};
}

std::vector<ReadRow> openscad_rows() {
  return {
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
  };
}

}  // namespace

const Reader kOpenscad{"OpenSCAD (.scad, .csg)",
                       nullptr,
                       is_openscad_suffix,
                       [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                         return read_openscad(path, openscad_options(o), c);
                       },
                       [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                         return inspect_openscad(path, openscad_options(o), c);
                       },
                       OpenscadFiles,
                       {},
                       openscad_rows};

}  // namespace burin::detail
