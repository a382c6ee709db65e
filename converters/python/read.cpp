#include "read.h"

#include <burin/base/error.h>

#include "style_text.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace burin::python {
namespace {

/// A value as OpenSCAD writes it.
std::string literal(const std::string& name, const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    std::string text = "\"";
    for (const char c : value.cast<std::string>()) {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
    return text + "\"";
  }
  const std::string text = value_text(name.c_str(), value);
  return py::isinstance<py::iterable>(value) ? "[" + text + "]" : text;
}

std::string word(const std::string& name, const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  throw py::type_error(
      fmt::format("argument {} takes a word, not {}", name, std::string(py::repr(value))));
}

/// What one keyword means on the command line: an option for each entry of a mapping
/// (define={"teeth": 12}) or of a list of texts.
std::vector<std::string> texts(const std::string& name, const py::handle& value) {
  std::vector<std::string> out;
  if (is_mapping(value)) {
    for (const py::handle item : value.attr("items")()) {
      const auto pair = item.cast<py::tuple>();
      const auto key = pair[0].cast<std::string>();
      out.push_back(key + "=" + (name == "define" ? literal(name, pair[1]) : word(name, pair[1])));
    }
    return out;
  }
  const bool list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (list && py::len(value) > 0 && py::isinstance<py::str>(value[py::int_(0)])) {
    for (const py::handle item : value) out.push_back(item.cast<std::string>());
    return out;
  }
  return {value_text(name.c_str(), value)};
}

/// One value, as text.
std::string text_of(const RequestOption& about, const py::handle& value) {
  const std::string& name = about.option.name;
  const std::string_view kind = kind_of(about.option);
  const auto may_be = [&](const char* type) {
    return about.python.find(type) != std::string::npos;
  };
  if (kind == "flag") return value_text(name.c_str(), value);
  if (kind == "number" || kind == "whole") return number_text(name.c_str(), value);
  if (kind == "direction") return list_text(name.c_str(), value);
  if (may_be("float | Sequence")) return value_text(name.c_str(), value);
  if (may_be("Sequence[str]")) {
    const std::vector<std::string> given = texts(name, value);
    const bool commas = std::ranges::any_of(
        given, [](const std::string& text) { return text.find(',') != std::string::npos; });
    return fmt::format("{}", fmt::join(given, commas ? ";" : ","));
  }
  if (may_be("Sequence")) return list_text(name.c_str(), value, name == "paper" ? "x" : ",");
  if (may_be("float")) return number_text(name.c_str(), value);
  return word(name, value);
}

}  // namespace

void add_keyword(DrawRequest& request, const RequestOption& option, const py::handle& value) {
  if (value.is_none()) return;
  const std::string& name = option.option.name;
  if (name == "style") return set_style(request, py::reinterpret_borrow<py::object>(value));
  std::vector<std::string> given;
  if (name == "set") {
    given = assignments(py::reinterpret_borrow<py::object>(value));
  } else if (option.many) {
    given = texts(name, value);
  } else {
    given = {text_of(option, value)};
  }
  if (std::ranges::any_of(given, &std::string::empty)) {
    throw UsageError(fmt::format("argument {} has an empty value", name));
  }
  if (!given.empty()) request.options[name] = std::move(given);
}

ReadOptions read_options(const py::kwargs& keywords, const std::vector<std::string>& others) {
  DrawRequest request;
  const std::vector<RequestOption> options = described(read_option_rows());
  for (const auto& [key, value] : keywords) {
    add_keyword(request, find_option(options, key.cast<std::string>(), known_words(others)), value);
  }
  return make_read_options(request.options, Spelling::Keywords);
}

}  // namespace burin::python
