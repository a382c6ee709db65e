#include "reader.h"

#include <burin/base/input_name.h>
#include <burin/converters/irit_reader.h>

#include "encoding.h"
#include "parts.h"
#include "patches.h"
#include "text.h"
#include "tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace irit {
namespace {

bool is_text(std::string_view text) {
  return text.substr(0, 1024).find('\0') == std::string_view::npos;
}

/// The text at `at`, a bracket, opens an object or a surface.
bool opens_object(std::string_view text, std::size_t at) {
  const std::size_t word = text.find_first_not_of(" \t\r\n", at + 1);
  if (word == std::string_view::npos) return false;
  const std::string keyword = lowered(text.substr(word, 8));
  return keyword.starts_with("object") || keyword.starts_with("surface");
}

/// One of the first brackets opens an object: before the first, anything is a comment.
bool has_object(std::string_view text) {
  std::size_t at = text.find('[');
  for (int brackets = 0; brackets < 20 && at != std::string_view::npos; ++brackets) {
    if (opens_object(text, at)) return true;
    at = text.find('[', at + 1);
  }
  return false;
}

/// The text begins with an object, or with comments that are marked as such.
bool begins_with_object(std::string_view text) {
  for (;;) {
    const std::size_t at = text.find_first_not_of(" \t\r\n");
    if (at == std::string_view::npos) return false;
    if (text[at] == '[') return opens_object(text, at);
    if (text[at] != '#') return false;
    const std::size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end);
  }
}

}  // namespace

Kind kind_of(const Source& source, const std::filesystem::path& path) {
  const std::string_view text = source.bytes();
  if (!is_text(text)) source.fail("is binary data, which is not read; write it as text (dat2irit)");
  if (is_geomview(text)) return Kind::Geomview;
  if (is_patch_list(text)) return Kind::List;
  const std::string suffix = model_suffix(path);
  const bool named = suffix == ".itd" || suffix == ".irt";
  if (has_object(text) || (named && text.find('[') != std::string_view::npos)) return Kind::Data;
  source.fail(
      "is neither IRIT data, which has [OBJECT, nor Bezier patches of Geomview (BEZ.., BBP), nor a "
      "patch list; is it another format?");
}

namespace {

Parts parts_of(const Source& source, const std::filesystem::path& path,
               const IritReadOptions& options) {
  switch (kind_of(source, path)) {
    case Kind::Geomview:
      return make_part(read_geomview(source), source, path);
    case Kind::List:
      return make_part(read_patch_list(source), source, path);
    case Kind::Data:
      break;
  }
  return make_parts(parse_tree(source), source, path, options);
}

}  // namespace

Parts read_parts(const std::filesystem::path& path, const RunContext& context,
                 const IritReadOptions& options) {
  const Source file(path, context);
  Diagnostics said;
  std::string text = utf8_text(file.bytes(), options.encoding, said);
  if (text.empty()) return parts_of(file, path, options);
  Parts parts = parts_of(Source(file.file(), std::move(text), context), path, options);
  parts.scene.diagnostics.append(said);
  return parts;
}

}  // namespace irit

bool is_irit_suffix(const std::filesystem::path& path) {
  constexpr std::array kSuffixes = {".itd", ".irt", ".bez", ".bbp"};
  const std::string suffix = model_suffix(path);
  return std::find(kSuffixes.begin(), kSuffixes.end(), suffix) != kSuffixes.end();
}

bool is_irit_content(std::string_view head) {
  return irit::is_text(head) &&
         (irit::is_geomview(head) || irit::is_patch_list(head) || irit::begins_with_object(head));
}

Scene read_irit(const std::filesystem::path& path, const RunContext& context,
                const IritReadOptions& options) {
  return irit::read_parts(path, context, options).scene;
}

}  // namespace burin
