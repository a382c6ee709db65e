#include "readers.h"

#include <burin/converters/cad_reader.h>
#include <burin/converters/irit_reader.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>

#include <array>
#include <fstream>
#include <string>

namespace burin::cli {
namespace {

constexpr Reader kMesh{
    "STL, OBJ, OFF, PLY, 3MF", nullptr, is_mesh_suffix,
    [](const std::filesystem::path& path, RunContext& context) { return read_mesh(path, context); },
    [](const std::filesystem::path& path, RunContext& context) {
      return inspect_mesh(path, context);
    }};

constexpr Reader kCad{"STEP, IGES, BREP", is_cad_content, is_cad_suffix, read_cad, inspect_cad};

constexpr Reader kIrit{
    "ITD, IRT, BEZ, BBP", is_irit_content, is_irit_suffix,
    [](const std::filesystem::path& path, RunContext& context) { return read_irit(path, context); },
    inspect_irit};

constexpr std::array kReaders{kCad, kIrit, kMesh};

/// Empty where the file cannot be read: its reader says why.
std::string head_of(const std::filesystem::path& path) {
  std::string head(kHeadBytes, '\0');
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

}  // namespace

const Reader& reader_of(const std::filesystem::path& path) {
  const std::string head = head_of(path);
  for (const Reader& reader : kReaders) {
    if (reader.knows_content && reader.knows_content(head)) return reader;
  }
  for (const Reader& reader : kReaders) {
    if (reader.knows_suffix(path)) return reader;
  }
  return kMesh;
}

}  // namespace burin::cli
