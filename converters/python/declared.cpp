#include "declared.h"

#include <burin/base/error.h>

#include "text.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace burin::python {
namespace {

constexpr double kLarge = 1e9;
constexpr double kLargestWhole = 9007199254740992.0;  // 2^53

bool is_word(const std::string& text, char joint) {
  const auto plain = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == joint;
  };
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z' && std::ranges::all_of(text, plain);
}

double number_of(const py::dict& row, const char* key, double otherwise) {
  return row.contains(key) ? row[key].cast<double>() : otherwise;
}

Takes takes_of(const py::dict& row) {
  const py::object fallback = row["default"];
  if (row.contains("words")) return WordList{row["words"].cast<std::vector<std::string>>()};
  if (py::isinstance<py::bool_>(fallback)) return Switch{};
  if (py::isinstance<py::str>(fallback)) return FreeText{};
  if (py::isinstance<py::sequence>(fallback)) return Direction{};
  if (py::isinstance<py::int_>(fallback)) {
    const double low = number_of(row, "low", 0), high = number_of(row, "high", kLargestWhole);
    if (!(low >= 0 && low <= high && high <= kLargestWhole)) {
      throw UsageError("whole numbers run from 0 on: \"low\" and \"high\"");
    }
    return WholeRange{static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high)};
  }
  const NumberRange range{number_of(row, "low", -kLarge), number_of(row, "high", kLarge),
                          row.contains("unit") ? row["unit"].cast<std::string>() : ""};
  if (!(range.low <= range.high)) throw UsageError("\"low\" is not below \"high\"");
  return range;
}

DeclaredOption option_of(const std::string& name, const py::object& value) {
  if (!is_word(name, '_')) throw UsageError("its name is not made of a-z, 0-9 and _");
  if (!py::isinstance<py::dict>(value) || !value.contains("default")) {
    throw UsageError(
        "it takes a dict with \"default\", and \"low\", \"high\", \"unit\", "
        "\"words\", \"meaning\" where they apply");
  }
  const auto row = value.cast<py::dict>();
  DeclaredOption out;
  out.option.name = name;
  out.option.meaning = row.contains("meaning") ? row["meaning"].cast<std::string>() : name;
  out.option.takes = takes_of(row);
  const auto fallback = parse_value(out.option, value_text("default", row["default"]));
  if (!fallback) {
    throw UsageError(fmt::format("its default is not what it takes, {}", takes_text(out.option)));
  }
  out.fallback = *fallback;
  return out;
}

py::object to_object(const Option& option, const OptionValue& value) {
  if (const auto* list = std::get_if<WordList>(&option.takes)) {
    return py::str(list->words[std::get<std::uint64_t>(value)]);
  }
  return std::visit(
      [](const auto& v) -> py::object {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Vec3>) {
          return py::make_tuple(v.x, v.y, v.z);
        } else {
          return py::cast(v);
        }
      },
      value);
}

}  // namespace

std::string_view kept(const std::string& text) {
  static std::deque<std::string> all;  // under the GIL
  const auto known = std::ranges::find(all, text);
  return known == all.end() ? all.emplace_back(text) : *known;
}

std::string checked_name(const std::string& name) {
  if (is_word(name, '-')) return name;
  throw UsageError(fmt::format("the name '{}' is not made of a-z, 0-9 and -", name));
}

std::vector<DeclaredOption> declared_options(const py::object& options) {
  std::vector<DeclaredOption> out;
  if (options.is_none()) return out;
  if (!is_mapping(options)) throw py::type_error("argument options takes a mapping of options");
  for (const py::handle item : options.attr("items")()) {
    const auto pair = item.cast<py::tuple>();
    const auto name = pair[0].cast<std::string>();
    try {
      out.push_back(option_of(name, pair[1]));
    } catch (const UsageError& e) {
      throw UsageError(fmt::format("option '{}': {}", name, e.what()));
    }
  }
  return out;
}

py::dict to_dict(const std::vector<DeclaredOption>& declared,
                 const std::vector<OptionValue>& values) {
  py::dict out;
  for (std::size_t i = 0; i < declared.size(); ++i) {
    out[py::str(declared[i].option.name)] = to_object(declared[i].option, values[i]);
  }
  return out;
}

}  // namespace burin::python
