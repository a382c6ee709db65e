#pragma once
/// Values of options from text; each error names its option.

#include <burin/base/box.h>
#include <burin/base/vec.h>

#include <cstdint>
#include <optional>
#include <string>

namespace burin::cli {

/// A number in [low, high]; nothing where the text is empty. Throws UsageError.
std::optional<double> number_option(const char* option, const std::string& text, double low,
                                    double high, const char* what);

/// A whole number in [low, high]. Throws UsageError.
std::uint64_t whole_option(const char* option, const std::string& text, std::uint64_t low,
                           std::uint64_t high, const char* what);

/// A direction X,Y,Z, any but zero. Throws UsageError.
Vec3 direction_option(const char* option, const std::string& text);

/// A box x0,y0,z0,x1,y1,z1 with each minimum below its maximum; nothing where the text is empty.
/// Throws UsageError.
std::optional<Box3> box_option(const char* option, const std::string& text);

}  // namespace burin::cli
