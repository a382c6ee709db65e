#pragma once
/// Which of the CAD formats a file has.

#include <filesystem>
#include <optional>
#include <string_view>

namespace burin {

enum class CadFormat { Step, Iges, BrepText, BrepBinary };

/// By the first bytes of a file.
std::optional<CadFormat> cad_format_of(std::string_view head);
std::optional<CadFormat> cad_format_of_suffix(const std::filesystem::path& path);

}  // namespace burin
