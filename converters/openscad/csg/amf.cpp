#include "amf.h"

#include <burin/base/error.h>

#include "package.h"
#include "source.h"
#include "text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <cmath>
#include <string>

namespace burin::csg {
namespace {

std::string unpacked(const Source& source) {
  if (!source.bytes().starts_with("PK")) return std::string(source.bytes());
  const Package package(source, "zipped AMF file");
  for (const std::string& name : package.names()) {
    if (lowered(name).ends_with(".amf")) return package.read(name);
  }
  const std::vector<std::string> names = package.names();
  if (names.size() != 1) source.fail("is an archive without an AMF file in it");
  return package.read(names[0]);
}

double number_of(const Source& source, const pugi::xml_node& node) {
  double value = 0;
  const std::string text = node.text().get();
  const std::size_t begin = text.find_first_not_of(" \t\r\n"),
                    end = text.find_last_not_of(" \t\r\n");
  if (begin == std::string::npos ||
      !parse_double(std::string_view(text).substr(begin, end - begin + 1), value) ||
      !std::isfinite(value)) {
    source.fail(fmt::format("has {} where a number belongs", in_quotes(text)));
  }
  return value;
}

void read_mesh_of(const Source& source, const pugi::xml_node& mesh, const RunContext& context,
                  PolygonSoup& soup) {
  const auto first = soup.positions.size();
  for (const auto& vertex : mesh.child("vertices").children("vertex")) {
    context.check();
    const auto at = vertex.child("coordinates");
    soup.positions.emplace_back(number_of(source, at.child("x")), number_of(source, at.child("y")),
                                number_of(source, at.child("z")));
  }
  const auto count = static_cast<double>(soup.positions.size() - first);
  for (const auto& volume : mesh.children("volume")) {
    for (const auto& triangle : volume.children("triangle")) {
      context.check();
      for (const char* name : {"v1", "v2", "v3"}) {
        const double index = number_of(source, triangle.child(name));
        if (!(index >= 0 && index < count)) {
          source.fail(fmt::format("has a triangle with the vertex {:g} of {:g}", index, count));
        }
        soup.indices.push_back(static_cast<std::uint32_t>(first) +
                               static_cast<std::uint32_t>(index));
      }
      soup.offsets.push_back(soup.indices.size());
    }
  }
}

}  // namespace

MeshFile read_amf(const std::filesystem::path& path, const RunContext& context) {
  const Source source(path, context);
  const std::string text = unpacked(source);
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) {
    source.fail(fmt::format("is no readable AMF ({} at byte {}); export it again",
                            result.description(), result.offset));
  }
  const pugi::xml_node root = document.child("amf");
  if (!root) source.fail("is XML, but no AMF; export it again");
  MeshFile file{"AMF", {}, {}};
  for (const auto& object : root.children("object")) {
    PolygonSoup soup;
    for (const auto& mesh : object.children("mesh")) read_mesh_of(source, mesh, context, soup);
    if (soup.polygon_count() > 0) file.objects.push_back(std::move(soup));
  }
  return file;
}

}  // namespace burin::csg
