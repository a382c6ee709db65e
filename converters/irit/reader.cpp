#include <burin/converters/irit_reader.h>
#include <burin/converters/mesh_reader.h>

#include "parts.h"
#include "patches.h"
#include "text.h"
#include "tree.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace burin {
namespace {

constexpr std::size_t kHead = 1 << 16;

enum class Kind { Data, Geomview, List, Unknown };

bool is_text(std::string_view head) { return head.find('\0') == std::string_view::npos; }

/// The first bracket that is no comment opens an object or one of its items.
bool is_irit_data(std::string_view text) {
  std::size_t at = 0;
  for (int brackets = 0; brackets < 8; ++brackets) {
    at = text.find('[', at);
    if (at == std::string_view::npos) return false;
    const std::size_t word = text.find_first_not_of(" \t\r\n", ++at);
    if (word == std::string_view::npos) return false;
    const std::string keyword = lowered(text.substr(word, 8));
    if (keyword.starts_with("object") || keyword.starts_with("surface ")) return true;
  }
  return false;
}

Kind kind_of(std::string_view head) {
  if (!is_text(head.substr(0, 1024))) return Kind::Unknown;
  if (irit::is_geomview(head)) return Kind::Geomview;
  if (irit::is_patch_list(head)) return Kind::List;
  return is_irit_data(head) ? Kind::Data : Kind::Unknown;
}

}  // namespace

bool is_irit_suffix(const std::filesystem::path& path) {
  constexpr std::array kSuffixes = {".itd", ".irt", ".bez", ".bbp"};
  const std::string suffix = lowered(path.extension().string());
  return std::find(kSuffixes.begin(), kSuffixes.end(), suffix) != kSuffixes.end();
}

bool is_irit_file(const std::filesystem::path& path) {
  if (is_irit_suffix(path)) return true;
  std::error_code error;
  if (is_mesh_suffix(path) || !std::filesystem::is_regular_file(path, error)) return false;
  std::string head(kHead, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return kind_of(head) != Kind::Unknown;
}

Scene read_irit(const std::filesystem::path& path, const RunContext& context) {
  const Source source(path, context);
  Kind kind = kind_of(source.bytes());
  const std::string suffix = lowered(path.extension().string());
  const bool text = is_text(source.bytes().substr(0, 1024));
  if (kind == Kind::Unknown && text && (suffix == ".itd" || suffix == ".irt") &&
      source.bytes().find('[') != std::string_view::npos) {
    kind = Kind::Data;
  }
  switch (kind) {
    case Kind::Geomview:
      return irit::make_part(irit::read_geomview(source), source, path);
    case Kind::List:
      return irit::make_part(irit::read_patch_list(source), source, path);
    case Kind::Data:
      return irit::make_parts(irit::parse_tree(source), source, path);
    case Kind::Unknown:
      break;
  }
  if (!text) {
    source.fail("is binary data, which is not read; write it as text (dat2irit)");
  }
  source.fail(
      "is neither IRIT data, which begins with [OBJECT, nor Bezier patches of Geomview (BEZ.., "
      "BBP), nor a patch list; is it another format?");
}

}  // namespace burin
