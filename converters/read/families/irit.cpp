#include <burin/converters/irit_reader.h>

#include "../readers.h"
#include "all.h"

namespace burin::detail {
namespace {

IritReadOptions irit_options(const ReadOptions& o) {
  return {o.volume.level.value_or(0), o.volume.inside_above.value_or(false), o.bounds, o.encoding};
}

}  // namespace

const Reader kIrit{"IRIT (.itd, .irt), Geomview patches (.bez, .bbp)",
                   is_irit_content,
                   is_irit_suffix,
                   [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                     return ReadResult{read_irit(path, c, irit_options(o))};
                   },
                   [](const std::filesystem::path& path, const ReadOptions& o, RunContext& c) {
                     return inspect_irit(path, c, irit_options(o));
                   },
                   Splines};

}  // namespace burin::detail
