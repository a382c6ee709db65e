#include "svg_file.h"

#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <utility>

namespace burin {
namespace {

constexpr std::uintmax_t kMostBytes = 8'000'000;
constexpr int kMostDepth = 100;

std::string text_of(const std::filesystem::path& path) {
  InputFiles::opens(path);
  const std::string name = path.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw MissingFile("there is no such drawing; check the path", name);
  }
  if (std::filesystem::file_size(path, error) > kMostBytes) {
    throw InputError("the drawing has more than 8 MB; a motif or a template is smaller", name);
  }
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw InputError("the drawing cannot be read", name);
  return text;
}

}  // namespace

SvgFile::SvgFile(const std::filesystem::path& path) : text_(text_of(path)), name_(path.string()) {
  const pugi::xml_parse_result result =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_comments);
  if (!result) fail(result.offset, fmt::format("bad XML ({})", result.description()));
  if (local_name(root()) != "svg") fail(0, "the file is no SVG");
}

std::string_view SvgFile::local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

void SvgFile::fail(std::ptrdiff_t offset, const std::string& what) const {
  const auto upto = text_.begin() + std::clamp<std::ptrdiff_t>(
                                        offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
  throw InputError(what, name_, 1 + std::count(text_.begin(), upto, '\n'));
}
void SvgFile::fail(const pugi::xml_node& node, const std::string& what) const {
  fail(node.offset_debug(), fmt::format("<{}>: {}", node.name(), what));
}

std::vector<double> SvgFile::numbers(const pugi::xml_node& node, std::string_view text) const {
  std::vector<double> out;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == ',' || c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at;
      continue;
    }
    double value = 0;
    const std::size_t from = c == '+' ? at + 1 : at;
    const auto read = std::from_chars(text.data() + from, text.data() + text.size(), value);
    if (read.ec != std::errc{} || !std::isfinite(value)) {
      fail(node, fmt::format("'{}' is no number", text.substr(at, 20)));
    }
    at = static_cast<std::size_t>(read.ptr - text.data());
    out.push_back(value);
  }
  return out;
}

double SvgFile::attribute(const pugi::xml_node& node, const char* name) const {
  const pugi::xml_attribute found = node.attribute(name);
  if (!found) return 0;
  std::string_view text = found.value();
  for (const std::string_view unit : {"px", "mm", "pt", "cm", "in", "pc", "%"}) {
    // Units of single lengths do not turn up in drawings of paths; a number tells the shape.
    if (text.ends_with(unit))
      fail(node, fmt::format("{} = '{}' has a unit; save the drawing in user units", name, text));
  }
  const std::vector<double> values = numbers(node, text);
  if (values.size() != 1) fail(node, fmt::format("{} = '{}' is no number", name, text));
  return values[0];
}

SvgTransform SvgFile::transform(const pugi::xml_node& node) const {
  std::string_view text = node.attribute("transform").value();
  SvgTransform all;
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n,");
    if (begin == std::string_view::npos) return all;
    const std::size_t open = text.find('(', begin), close = text.find(')', begin);
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      fail(node, "the transformation cannot be read");
    }
    std::string_view word = text.substr(begin, open - begin);
    while (word.ends_with(' ')) word.remove_suffix(1);
    const std::vector<double> n = numbers(node, text.substr(open + 1, close - open - 1));
    all = all.of(step(node, word, n));
    text.remove_prefix(close + 1);
  }
}

SvgTransform SvgFile::step(const pugi::xml_node& node, std::string_view word,
                           const std::vector<double>& n) const {
  const std::size_t count = n.size();
  constexpr double kRadian = std::numbers::pi / 180;
  if (word == "matrix" && count == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  if (word == "translate" && (count == 1 || count == 2)) {
    return {1, 0, 0, 1, n[0], count == 2 ? n[1] : 0};
  }
  if (word == "scale" && (count == 1 || count == 2)) return {n[0], 0, 0, n[count - 1], 0, 0};
  if (word == "rotate" && (count == 1 || count == 3)) {
    const double c = std::cos(n[0] * kRadian), s = std::sin(n[0] * kRadian);
    const SvgTransform turn{c, s, -s, c, 0, 0};
    if (count == 1) return turn;
    return SvgTransform{1, 0, 0, 1, n[1], n[2]}.of(turn).of({1, 0, 0, 1, -n[1], -n[2]});
  }
  if (word == "skewX" && count == 1) return {1, 0, std::tan(n[0] * kRadian), 1, 0, 0};
  if (word == "skewY" && count == 1) return {1, std::tan(n[0] * kRadian), 0, 1, 0, 0};
  fail(node, fmt::format("unknown transformation '{}' of {} numbers", word, count));
}

std::string SvgFile::data(const pugi::xml_node& node) const {
  const std::string_view name = local_name(node);
  const auto number = [&](const char* key) { return attribute(node, key); };
  if (name == "path") return node.attribute("d").value();
  if (name == "line") {
    return fmt::format("M{} {}L{} {}", number("x1"), number("y1"), number("x2"), number("y2"));
  }
  if (name == "polyline" || name == "polygon") {
    const std::vector<double> n = numbers(node, node.attribute("points").value());
    if (n.size() < 4) return {};
    std::string out;
    for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
      out += fmt::format("{}{} {}", i == 0 ? "M" : "L", n[i], n[i + 1]);
    }
    return name == "polygon" ? out + "Z" : out;
  }
  if (name == "rect") {
    const double w = number("width"), h = number("height");
    if (!(w > 0 && h > 0)) return {};
    return fmt::format("M{} {}h{}v{}h{}Z", number("x"), number("y"), w, h, -w);
  }
  if (name == "circle" || name == "ellipse") {
    const double rx = number(name == "circle" ? "r" : "rx"),
                 ry = number(name == "circle" ? "r" : "ry");
    if (!(rx > 0 && ry > 0)) return {};
    return fmt::format("M{0} {1}a{2} {3} 0 1 1 {4} 0a{2} {3} 0 1 1 {5} 0Z", number("cx") - rx,
                       number("cy"), rx, ry, 2 * rx, -2 * rx);
  }
  return {};
}

void SvgFile::walk(const SvgTransform& outer, const Take& take) const {
  walk(root(), outer, take, 0);
}

void SvgFile::walk(const pugi::xml_node& node, const SvgTransform& outer, const Take& take,
                   int depth) const {
  constexpr std::array<std::string_view, 6> kUndrawn{"defs", "symbol", "clipPath",
                                                     "mask", "marker", "pattern"};
  if (depth > kMostDepth) fail(node, "elements are nested too deep");
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string_view name = local_name(child);
    if (std::ranges::find(kUndrawn, name) != kUndrawn.end()) continue;
    if (std::string_view(child.attribute("display").value()) == "none") continue;
    const SvgTransform here = outer.of(transform(child));
    take(child, here);
    if (name != "text") walk(child, here, take, depth + 1);
  }
}

std::vector<Subpath> SvgFile::lines(const pugi::xml_node& node,
                                    const SvgTransform& transform) const {
  const std::string text = data(node);
  if (text.empty()) return {};
  try {
    std::vector<Subpath> path = parse_path_data(text);
    for (Subpath& sub : path) {
      for (CubicBezier& c : sub.curves) {
        for (Vec2& p : c) p = transform(p);
      }
    }
    return path;
  } catch (const UsageError& e) {
    fail(node, e.what());
  }
}

}  // namespace burin
