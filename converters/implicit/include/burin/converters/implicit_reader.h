#pragma once
/// Implicit functions as text (`.implicit` files).

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The formula that a text defines: `name = expression;` any number of times, then one expression,
/// as kernel/docs/implicit.md explains. Throws InputError with `file`, the line, and the column in
/// the message. Never more than 200 parentheses deep; texts over 1 MB are refused.
Expression parse_implicit(std::string_view text, const std::string& file = {});

/// Whether the suffix (any case) is `.implicit`.
bool is_implicit_suffix(const std::filesystem::path& path);

struct ImplicitReadOptions {
  /// The domain; absent = the function's own bounds, and where it has none an error that asks for
  /// it.
  std::optional<Box3> bounds = {};
  ImplicitProxyOptions proxy = {};
};

/// One part, named by the file. Throws InputError also where the function has no surface.
Scene read_implicit(const std::filesystem::path& path, const ImplicitReadOptions& options,
                    const RunContext& context);

/// The same of a text; its part is called "function". `file` names it in errors.
Scene read_implicit_text(std::string_view text, const std::string& file,
                         const ImplicitReadOptions& options, const RunContext& context);

/// Reads and measures triangles within a ten-thousandth of the size; faces are smooth regions.
FileInfo inspect_implicit(const std::filesystem::path& path, const ImplicitReadOptions& options,
                          RunContext& context);

}  // namespace burin
