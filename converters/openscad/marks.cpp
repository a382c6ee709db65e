#include "marks.h"

#include <burin/base/error.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::detail {
namespace {

using Json = nlohmann::ordered_json;

// The first point of a mark; burin.scad writes the same digits.
constexpr std::array kMarkSign = {0.271828, 0.314159, 0.141421};
// What a point of a mark begins with: the kind of the value that follows.
enum class ValueKind : std::uint8_t { Undef, Bool, Number, Text, List };
constexpr double kLargestCode = 0x10ffff;
constexpr int kDeepestList = 8;

/// A character as UTF-8.
void append(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t b) { text += static_cast<char>(b); };
  const auto more = [&](int shift) { byte(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xc0 | (code >> 6));
    more(0);
  } else if (code < 0x10000) {
    byte(0xe0 | (code >> 12));
    more(6);
    more(0);
  } else {
    byte(0xf0 | (code >> 18));
    more(12);
    more(6);
    more(0);
  }
}

/// Values from points; false where they are none that burin.scad writes.
class Decoder {
 public:
  explicit Decoder(std::span<const csg::Value> points) : points_(points) {}

  bool value(Json& out, int depth = 0) {
    std::array<double, 2> p{};
    if (depth > kDeepestList || !point(p)) return false;
    if (!(p[0] >= 0 && p[0] <= static_cast<double>(ValueKind::List))) return false;
    switch (static_cast<ValueKind>(static_cast<int>(p[0]))) {
      case ValueKind::Undef:
        return true;
      case ValueKind::Bool:
        out = p[1] != 0;
        return true;
      case ValueKind::Number:
        out = p[1];
        return true;
      case ValueKind::Text:
        return text(out, p[1]);
      case ValueKind::List:
        return list(out, p[1], depth);
    }
    return false;
  }

 private:
  bool point(std::array<double, 2>& out) {
    if (at_ >= points_.size() || points_[at_].list.size() != 3) return false;
    const auto& list = points_[at_++].list;
    out = {list[0].number, list[1].number};
    return true;
  }
  bool fits(double count) const {
    return count >= 0 && count <= static_cast<double>(points_.size() - at_);
  }
  bool text(Json& out, double count) {
    if (!fits(count)) return false;
    std::string text;
    for (double i = 0; i < count; ++i) {
      std::array<double, 2> p{};
      if (!point(p) || !(p[0] >= 0 && p[0] <= kLargestCode)) return false;
      append(text, static_cast<std::uint32_t>(p[0]));
    }
    out = text;
    return true;
  }
  bool list(Json& out, double count, int depth) {
    if (!fits(count)) return false;
    out = Json::array();
    for (double i = 0; i < count; ++i) {
      Json item;
      if (!value(item, depth + 1)) return false;
      out.push_back(std::move(item));
    }
    return true;
  }

  std::span<const csg::Value> points_;
  std::size_t at_ = 0;
};

bool signed_by_us(const csg::Value& point) {
  if (point.list.size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(point.list[i].number - kMarkSign[i]) > 1e-9) return false;
  }
  return true;
}

}  // namespace

std::optional<Mark> mark_at(const csg::Tree& tree, std::uint32_t node) {
  const csg::Node& n = tree.nodes[node];
  if (n.module != csg::Module::Polyhedron) return std::nullopt;
  const csg::Value* points = n.argument("points");
  if (!points || points->list.empty() || !signed_by_us(points->list.front())) return std::nullopt;
  Json all;
  Decoder decoder(std::span(points->list).subspan(1));
  if (!decoder.value(all) || !all.is_array() || all.empty() || !all[0].is_string()) {
    throw InputError(
        "a mark of burin.scad that this Burin does not read; use the burin.scad that "
        "came with it",
        tree.file);
  }
  Mark mark{all[0], Json::array()};
  for (std::size_t i = 1; i < all.size(); ++i) mark.arguments.push_back(all[i]);
  return mark;
}

std::optional<Mark> mark_of_group(const csg::Tree& tree, std::uint32_t node) {
  const auto first = [&](std::uint32_t n) { return n + 1 < tree.nodes[n].end ? n + 1 : n; };
  if (tree.nodes[node].module != csg::Module::Group) return std::nullopt;
  const std::uint32_t says = first(node), holds = first(says);
  if (says == node || holds == says) return std::nullopt;
  if (tree.nodes[says].module != csg::Module::Group ||
      tree.nodes[holds].end != tree.nodes[says].end)
    return std::nullopt;
  return mark_at(tree, holds);
}

}  // namespace burin::detail
