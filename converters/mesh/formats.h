#pragma once
/// One reader per format, and the choice of the one that a file needs.

#include <burin/converters/mesh_reader.h>

#include "source.h"

namespace burin {

enum class MeshFormat { StlBinary, StlAscii, Obj, Off, Ply, ThreeMf, Amf };

/// By content where that is clear, else by the suffix. Throws InputError, saying what the file is
/// instead, where it is none of ours.
MeshFormat detect_format(const Source& source, const std::filesystem::path& path);

MeshFile read_stl_binary(const Source& source);
MeshFile read_stl_ascii(const Source& source);
MeshFile read_obj(const Source& source);
MeshFile read_off(const Source& source);
MeshFile read_ply(const Source& source);
MeshFile read_3mf(const Source& source);
MeshFile read_amf(const Source& source);

}  // namespace burin
