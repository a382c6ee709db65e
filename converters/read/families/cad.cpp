#include <burin/converters/cad_reader.h>

#include "../readers.h"
#include "all.h"

namespace burin::detail {

const Reader kCad{"STEP, IGES, BREP",
                  is_cad_content,
                  is_cad_suffix,
                  [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                    return ReadResult{read_cad(path, c, {o.encoding, o.pmi})};
                  },
                  [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                    return inspect_cad(path, c, {o.encoding, true});
                  },
                  CadFiles,
                  {},
                  nullptr,
                  true};

}  // namespace burin::detail
