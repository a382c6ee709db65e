#include "title_block_option.h"

#include <burin/annotate/title_block.h>
#include <burin/base/ascii.h>
#include <burin/converters/pictures.h>
#include <burin/options/meant.h>

#include "draw_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace burin::detail {
namespace {

std::vector<std::string> fields_of(const TitleBlock& block) {
  std::vector<std::string> names;
  if (!block.layout) {
    for (const TitleBlockField& field : title_block_fields()) names.emplace_back(field.name);
    return names;
  }
  std::set<std::string> known;
  for (const TitleBlockText& text : block.layout->texts) {
    if (!text.field.empty() && known.insert(text.field).second) names.push_back(text.field);
  }
  return names;
}

void set_field(TitleBlock& block, const std::string& spelled, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse_value(spelled, "NAME=TEXT", text);
  const std::string name = text.substr(0, equals);
  const std::vector<std::string> known = fields_of(block);
  if (std::ranges::find(known, name) == known.end()) {
    refuse_value(spelled,
                 known.empty() ? "no field: the template has no text that is one"
                               : fmt::format("NAME=TEXT with a name of {}", fmt::join(known, ", ")),
                 text);
  }
  block.fields[name] = text.substr(equals + 1);
}

}  // namespace

void set_title_block(Draft& draft, const Asked& asked) {
  const std::string& text = asked.text();
  std::optional<TitleBlock>& block = draft.plan.title_block;
  block.reset();
  if (equal_but_for_case(text, "none")) return;
  if (equal_but_for_case(text, "iso")) {
    block.emplace();
    return;
  }
  if (lowered(std::filesystem::path(text).extension().string()) != ".svg") {
    refuse_value(asked.spelled, "iso, none or FILE.svg", text);
  }
  block.emplace().layout = std::make_shared<const TitleBlockLayout>(read_title_block(text));
}

void set_title_block_fields(Draft& draft, const Asked& asked) {
  if (!draft.plan.title_block) return;  // `unused_choices` reports it
  for (const std::string& text : asked.texts) {
    set_field(*draft.plan.title_block, asked.spelled, text);
  }
}

}  // namespace burin::detail
