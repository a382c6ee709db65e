#pragma once
/// Values of options from text; each error names its option. Names that begin with "--" are those
/// of the command line ("option --scale takes ..."), others those of a program ("argument scale
/// takes ...").

#include <burin/arrange/section.h>
#include <burin/base/box.h>
#include <burin/base/vec.h>
#include <burin/camera/sheet.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A whole number in [low, high]. Throws UsageError.
std::uint64_t whole_option(const std::string& option, const std::string& text, std::uint64_t low,
                           std::uint64_t high, const char* what);

/// A point X,Y,Z; nothing where the text is empty. Throws UsageError.
std::optional<Vec3> point_option(const std::string& option, const std::string& text);

/// A plane across an axis, "AXIS[=MM]"; the side is that of the sign, or of a direction X,Y,Z.
/// Throws UsageError.
SectionPlane cut_option(const std::string& option, const std::string& text);

/// Exactly as many finite numbers as there is room for, between commas; false for other texts.
bool parse_list(std::string_view text, std::span<double> out);

/// A box x0,y0,z0,x1,y1,z1 with each minimum below its maximum; nothing where the text is empty.
/// Throws UsageError.
std::optional<Box3> box_option(const std::string& option, const std::string& text);

/// A scale in [low, high] as a number or as A:B (1:2 is 0.5); nothing where the text is empty.
/// Throws UsageError.
std::optional<double> scale_option(const std::string& option, const std::string& text, double low,
                                   double high);

/// A margin in mm: one number, or TOP,RIGHT,BOTTOM,LEFT; each pair leaves 2 mm of the `sheet`, one
/// number half of that on each side. Nothing where the text is empty. Throws UsageError.
std::optional<Margin> margin_option(const std::string& option, const std::string& text, Vec2 sheet);

/// The beginning of ids: empty, or a letter or _ and then letters, digits, - _ and dots. Throws
/// UsageError.
std::string id_prefix_option(const std::string& option, const std::string& text);

}  // namespace burin
