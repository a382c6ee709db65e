#pragma once
/// The pairs of code and value that DXF is made of.

#include <burin/base/vec.h>
#include <burin/drawing/text.h>

#include <cstdint>
#include <string_view>

namespace burin::dxf {

/// Handles of what every file has; those of layers and entities follow.
enum class Fixed : std::uint64_t {
  VportTable = 0x1,
  LtypeTable,
  LayerTable,
  StyleTable,
  ViewTable,
  UcsTable,
  AppidTable,
  DimstyleTable,
  BlockTable,
  Vport = 0x10,
  ByBlock,
  ByLayer,
  Continuous,
  Dashed,
  LayerZero,
  Style,
  Acad,
  Burin,
  Dimstyle,
  ModelSpace,
  PaperSpace,
  ModelBlock,
  ModelEnd,
  PaperBlock,
  PaperEnd,
  Root,
  Groups,
  Layouts,
  MlineStyles,
  PlotSettings,
  PlotStyles,
  Placeholder,
  ModelLayout,
  PaperLayout,
  MlineStyle,
  DashDot,
  LongDashDot,
  FirstLayer = 0x100
};

inline constexpr std::string_view kContinuous = "Continuous";
inline constexpr std::string_view kDashed = "ACAD_ISO02W100";
inline constexpr std::string_view kDashDot = "ACAD_ISO10W100";
inline constexpr std::string_view kLongDashDot = "ACAD_ISO04W100";
/// The application whose extended data (XDATA) names the source of an entity.
inline constexpr std::string_view kApplication = "BURIN";

/// Appends groups to a buffer.
class Groups {
 public:
  explicit Groups(Buffer& out) : out_(out) {}

  Groups& text(int code, std::string_view value) {
    fmt::format_to(fmt::appender(out_), "{}\n{}\n", code, value);
    return *this;
  }
  Groups& whole(int code, std::int64_t value) {
    fmt::format_to(fmt::appender(out_), "{}\n{}\n", code, value);
    return *this;
  }
  Groups& handle(int code, std::uint64_t value) {
    fmt::format_to(fmt::appender(out_), "{}\n{:X}\n", code, value);
    return *this;
  }
  Groups& handle(int code, Fixed value) { return handle(code, static_cast<std::uint64_t>(value)); }
  /// Rounded to 1e-6, or to so many decimals; with a point, which strict readers want.
  Groups& real(int code, double value, int decimals = 6) {
    fmt::format_to(fmt::appender(out_), "{}\n", code);
    const std::size_t begin = out_.size();
    append_fixed(out_, value, decimals);
    const std::string_view digits(out_.data() + begin, out_.size() - begin);
    append(out_, digits.find_first_of(".e") == std::string_view::npos ? ".0\n" : "\n");
    return *this;
  }
  Groups& point(int code, Vec2 p) { return real(code, p.x).real(code + 10, p.y); }
  Groups& point(int code, Vec3 p) { return point(code, Vec2(p)).real(code + 20, p.z); }

 private:
  Buffer& out_;
};

}  // namespace burin::dxf
