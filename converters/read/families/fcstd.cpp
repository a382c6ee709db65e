#include <burin/converters/fcstd_reader.h>

#include "../readers.h"
#include "all.h"

namespace burin::detail {
namespace {

FcstdOptions fcstd_options(const ReadOptions& o) {
  return {o.objects, o.recompute, o.freecad_timeout};
}

std::vector<ReadRow> fcstd_rows() {
  return {
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
  };
}

}  // namespace

const Reader kFcstd{"FreeCAD (.FCStd)",
                    is_fcstd_content,
                    is_fcstd_suffix,
                    [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                      return ReadResult{read_fcstd(path, fcstd_options(o), c)};
                    },
                    [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                      return inspect_fcstd(path, fcstd_options(o), c);
                    },
                    FreecadFiles,
                    {},
                    fcstd_rows};

}  // namespace burin::detail
