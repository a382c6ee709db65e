#pragma once
// An SVG file and what its elements draw; internal to the module.

#include <burin/base/vec.h>
#include <burin/drawing/path_data.h>

#include <pugixml.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// x' = a x + c y + e, y' = b x + d y + f.
struct SvgTransform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this.
  SvgTransform of(const SvgTransform& inner) const {
    const Vec2 x = Vec2(a * inner.a + c * inner.b, b * inner.a + d * inner.b);
    const Vec2 y = Vec2(a * inner.c + c * inner.d, b * inner.c + d * inner.d);
    const Vec2 o = (*this)({inner.e, inner.f});
    return {x.x, x.y, y.x, y.y, o.x, o.y};
  }
};

class SvgFile {
 public:
  /// Throws InputError, MissingFile where it is no SVG or larger than 8 MB.
  explicit SvgFile(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  pugi::xml_node root() const { return document_.document_element(); }
  static std::string_view local_name(const pugi::xml_node& node);
  /// Throws InputError with the line.
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const;

  /// The numbers of a text, parted by what is none.
  std::vector<double> numbers(const pugi::xml_node& node, std::string_view text) const;
  double attribute(const pugi::xml_node& node, const char* name) const;

  /// Gives each element that is drawn, from the outside in, with where it is; texts whole.
  using Take = std::function<void(const pugi::xml_node& node, const SvgTransform& transform)>;
  void walk(const SvgTransform& outer, const Take& take) const;
  /// Those of an element itself; none where it is no shape.
  std::vector<Subpath> lines(const pugi::xml_node& node, const SvgTransform& transform) const;

 private:
  SvgTransform transform(const pugi::xml_node& node) const;
  SvgTransform step(const pugi::xml_node& node, std::string_view word,
                    const std::vector<double>& n) const;
  /// What a shape is as path data; empty: none that has lines.
  std::string data(const pugi::xml_node& node) const;
  void walk(const pugi::xml_node& node, const SvgTransform& outer, const Take& take,
            int depth) const;

  std::string text_, name_;
  pugi::xml_document document_;
};

}  // namespace burin
