#include <burin/converters/implicit_reader.h>

#include "../readers.h"
#include "all.h"

namespace burin::detail {

const Reader kImplicit{"functions (.implicit)",
                       nullptr,
                       is_implicit_suffix,
                       [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                         return ReadResult{read_implicit(path, {o.bounds, {o.mesher}}, c)};
                       },
                       [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                         return inspect_implicit(path, {o.bounds, {o.mesher}}, c);
                       },
                       Functions};

}  // namespace burin::detail
