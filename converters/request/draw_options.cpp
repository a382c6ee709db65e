#include "draw_options.h"

#include <burin/base/ascii.h>
#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/converters/values.h>

#include "arrow_option.h"
#include "explode_option.h"
#include "note_option.h"
#include "section_option.h"
#include "thread_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace burin {
namespace detail {
namespace {

constexpr const char* kRun = "The run";
constexpr const char* kFiles = "Files";

std::vector<RequestRow<Draft>> explode_option_rows() {
  return {
      {{.option = {.name = "explode",
                   .meaning = "take the assembly apart: auto, or along one axis alone, x, y, z or "
                              "a direction, +y and -y one way; none: as if not asked for",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "auto|AXIS",
        .choices = {"auto", "x", "y", "z", "none"},
        .python = "str | Sequence[float]",
        .also = {"exploded", "exploded view", "explosion", "disassemble", "apart", "take apart",
                 "explode view"}},
       [](Draft& d, const Asked& a) { set_explode(d.plan.explode, a.spelled, a.text()); }},
      {{.option = {.name = "explode_factor",
                   .meaning =
                       "how far parts have come on their ways, from 0, together, to 1, apart "
                       "(default 1)",
                   .takes = NumberRange{0, 10}},
        .group = kParts,
        .label = "F",
        .also = {"explosion factor", "explode distance", "spread", "explode scale"}},
       [](Draft& d, const Asked& a) { d.plan.explode.factor = std::get<double>(a.value); }},
  };
}

/// "sheet", or files that end in .csv or .json.
void set_parts_list(Draft& draft, const Asked& asked) {
  for (const std::string& text : asked.texts) {
    const std::string suffix = lowered(std::filesystem::path(text).extension().string());
    if (text == "sheet") {
      draft.plan.parts_list = true;
    } else if (suffix == ".csv" || suffix == ".json") {
      draft.plan.parts_list_files.push_back(text);
      draft.plan.items = true;
    } else {
      refuse_value(asked.spelled, "sheet, FILE.csv or FILE.json", text);
    }
  }
}

std::vector<RequestRow<Draft>> item_option_rows() {
  return {
      {{.option = {.name = "callouts",
                   .meaning = "a number at each item, with a leader; looks: style keys callout.*",
                   .takes = Switch{}},
        .group = kParts,
        .negated = "draw none, even if the illustration file asks for them",
        .also = {"balloons", "balloon", "labels", "label", "numbers", "item numbers", "leaders",
                 "annotations", "annotate", "bubbles", "tags"}},
       [](Draft& d, const Asked& a) { d.plan.callouts = std::get<bool>(a.value); }},
      {{.option = {.name = "parts_list",
                   .meaning = "number, name and quantity of each item: on the sheet, or as a file "
                              "with colour and source; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "sheet|FILE.csv|FILE.json",
        .choices = {"sheet"},
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"bom", "bill of materials", "parts table", "list", "partlist", "stueckliste",
                 "components list", "csv"}},
       set_parts_list},
      {{.option = {.name = "legend",
                   .meaning = "list the colours of parts with their names on the sheet; where: "
                              "style key callout.legend",
                   .takes = Switch{}},
        .group = kParts,
        .negated = "draw none, even if the illustration file asks for it",
        .also = {"key", "color key", "colour key", "color legend", "color list", "swatches"}},
       [](Draft& d, const Asked& a) { d.plan.legend = std::get<bool>(a.value); }},
  };
}

std::vector<RequestRow<Draft>> run_rows() {
  return {
      {{.option = {.name = "seed",
                   .meaning = "random seed (default 1)",
                   .takes = WholeRange{0, std::numeric_limits<std::uint64_t>::max()},
                   .phrase = "a whole number from 0"},
        .group = kRun,
        .label = "N",
        .fallback = "1",
        .also = {"random", "random seed"}},
       [](Draft& d, const Asked& a) { d.plan.illustrate.seed = std::get<std::uint64_t>(a.value); }},
      {{.option = {.name = "threads",
                   .meaning = "worker threads (default: all); the drawing is the same for any "
                              "number",
                   .takes = WholeRange{1, 4096}},
        .group = kRun,
        .label = "N",
        .also = {"jobs", "cores", "cpus", "parallel", "workers", "j", "num threads", "nproc"}},
       [](Draft& d, const Asked& a) {
         d.plan.threads = static_cast<int>(std::get<std::uint64_t>(a.value));
       }},
      {{.option = {.name = "verify",
                   .meaning =
                       "test every visible and hidden line of the drawing, and its areas, by "
                       "rays against a finer tessellation of its own; list what is wrong, "
                       "where, and how much in all",
                   .takes = Switch{}},
        .group = kRun,
        .also = {"check", "test", "validate", "prove"}},
       [](Draft& d, const Asked& a) { d.plan.illustrate.verify = std::get<bool>(a.value); }},
      {{.option = {.name = "id_prefix",
                   .meaning = "prefix of all ids of an SVG, so that one page can hold several",
                   .takes = FreeText{}},
        .group = kFiles,
        .label = "TEXT",
        .also = {"prefix", "css prefix", "svg prefix", "svg ids", "namespace"}},
       [](Draft& d, const Asked& a) { d.plan.id_prefix = id_prefix_option(a.spelled, a.text()); }},
  };
}

}  // namespace

std::pair<std::string, std::string> name_and_value(const std::string& spelled,
                                                   const std::string& takes,
                                                   const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    refuse_value(spelled, takes, text);
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

const std::vector<RequestRow<Draft>>& draw_rows() {
  static const std::vector<RequestRow<Draft>> all = [] {
    std::vector<RequestRow<Draft>> rows;
    for (const auto& group : {look_option_rows(), part_option_rows(), section_rows(),
                              explode_option_rows(), item_option_rows(), thread_rows(), note_rows(),
                              arrow_rows(), view_rows(), sheet_rows(), run_rows()}) {
      rows.insert(rows.end(), group.begin(), group.end());
    }
    return rows;
  }();
  return all;
}

}  // namespace detail

namespace {

std::vector<RequestOption> by_headings() {
  std::vector<RequestOption> options = described(detail::draw_rows());
  const std::vector<RequestOption> reading = described(read_option_rows());
  options.insert(options.end(), reading.begin(), reading.end());
  // Under their headings, each as it came.
  const std::vector<std::string> headings = {
      "Files", "The look", "Parts", "The sheet and the view", "Functions and volumes", "The run"};
  std::ranges::stable_sort(options, {}, [&](const RequestOption& option) {
    return std::ranges::find(headings, option.group) - headings.begin();
  });
  return options;
}

}  // namespace

const std::vector<RequestOption>& all_options() {
  static MadeOfCatalogues<std::vector<RequestOption>> options;
  return options.get(by_headings);
}

std::pair<std::string, std::string> parted_assignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse_value("--set", "KEY=VALUE", text);
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace burin
