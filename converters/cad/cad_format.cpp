#include "cad_format.h"

#include <burin/base/ascii.h>
#include <burin/base/input_name.h>

#include "byte_order_mark.h"

#include <string>

namespace burin {
namespace {

constexpr std::size_t kFar = 2048;  // what writers put before the first word

std::string_view without_space(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\v\f\r\n");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

/// STEP may begin with blanks, a byte order mark and comments.
bool is_step(std::string_view text) {
  text.remove_prefix(byte_order_mark(text));
  text = without_space(text);
  while (text.starts_with("/*")) {
    const std::size_t end = text.find("*/");
    if (end == std::string_view::npos) return false;
    text = without_space(text.substr(end + 2));
  }
  return text.starts_with("ISO-10303-21");
}

/// Lines of 80 columns whose 73rd is the letter of the section and whose last seven are the number
/// of the line in it.
bool is_iges(std::string_view text) {
  if (text.size() < 80) return false;
  const auto number = text.substr(73, 7);
  const std::size_t digits = number.find_first_not_of(" 0");
  return text[72] == 'S' && digits != std::string_view::npos && number.substr(digits) == "1";
}

}  // namespace

std::optional<CadFormat> cad_format_of(std::string_view head) {
  if (is_step(head)) return CadFormat::Step;
  const std::string_view begin = head.substr(0, kFar);
  if (begin.find("DBRep_DrawableShape") != std::string_view::npos ||
      without_space(begin).starts_with("CASCADE Topology V"))
    return CadFormat::BrepText;
  if (without_space(begin).starts_with("Open CASCADE Topology V")) return CadFormat::BrepBinary;
  if (is_iges(head)) return CadFormat::Iges;
  return std::nullopt;
}

std::optional<CadFormat> cad_format_of_suffix(const std::filesystem::path& path) {
  const std::string suffix = model_suffix(path);
  if (suffix == ".step" || suffix == ".stp" || suffix == ".p21") return CadFormat::Step;
  if (suffix == ".iges" || suffix == ".igs") return CadFormat::Iges;
  if (suffix == ".brep" || suffix == ".brp") return CadFormat::BrepText;
  return std::nullopt;
}

}  // namespace burin
