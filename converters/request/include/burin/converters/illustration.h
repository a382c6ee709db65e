#pragma once
/// Illustration files (NAME.burin.json): which parts are drawn, where they stand, how they look, by
/// what light, from where, on what paper. A model is never changed by one;
/// kernel/docs/illustrations.md explains the keys.

#include <burin/base/placement.h>
#include <burin/converters/read_result.h>
#include <burin/converters/request.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// One input of an illustration: a file or a formula, with what is asked of its reading.
struct IllustrationInput {
  /// As it is found from here; empty for a formula.
  std::string file;
  /// The text of an `.implicit` file.
  std::string function;
  /// What its part is called, or where its parts stand in the assembly; empty: as the file says.
  std::string name;
  Placement place;
  /// Options about reading, by name.
  Request read;
  /// For errors: the illustration file and the line.
  std::string source;
  std::int64_t line = 0;
};

/// What an illustration file says.
struct IllustrationFile {
  std::vector<IllustrationInput> inputs;
  /// All else, as a front end would ask it.
  DrawRequest request;
};

/// Whether a file is an illustration: by its suffix `.json`. Drawing files have it too, and are
/// refused by `read_illustration`.
bool is_illustration(const std::filesystem::path& path);

/// Reads an illustration and what it extends. Files that it names are looked for from its folder.
/// Throws InputError on broken JSON, UsageError ("FILE:LINE: ...") on unknown keys and values that
/// a key does not take. `members`, where given, gets the members of the illustration and, where it
/// has none of a name, of what it extends, as JSON has them.
IllustrationFile read_illustration(const std::filesystem::path& path,
                                   std::string* members = nullptr);
/// The same from text; `source` names it in errors, its folder is where files are looked for.
IllustrationFile parse_illustration(std::string_view json, const std::string& source,
                                    std::string* members = nullptr);

/// All that an illustration says but parts, which it must not have: what a program asks of a scene
/// that it has. Throws as `parse_illustration`.
DrawRequest parse_settings(std::string_view json, const std::string& source);

/// The parts of its inputs, placed. Inputs that are equal but for place and name are read once.
/// Stage "read". Throws InputError.
Scene read_scene(const IllustrationFile& illustration, RunContext& context);

/// What a front end asks, over what an illustration does: options that are given replace those of
/// the file; those that may be given several times follow them.
DrawRequest merged(const DrawRequest& file, const DrawRequest& over);

/// What is asked, and below it what marks in models ask, as an illustration file says it; the steps
/// of an exploded view are not among it. Throws UsageError that names model and mark.
DrawRequest with_marks(const std::vector<ModelMarks>& marks, DrawRequest request);

/// A first file to edit, of these inputs and of what was asked; with paths as seen from `folder`.
/// `steps`: of an exploded view.
std::string first_illustration(const std::vector<std::string>& inputs, const DrawRequest& request,
                               const std::filesystem::path& folder,
                               const std::vector<ExplodeStep>& steps = {});

/// A file that extends an illustration, `base_illustration`, by the steps of an exploded view.
std::string exploded_illustration(const std::string& base_illustration, const DrawRequest& request,
                                  const std::filesystem::path& folder,
                                  const std::vector<ExplodeStep>& steps);

/// A file that extends an illustration, `base_illustration`, by its dimensions and notes as
/// `keep_features` left them.
std::string kept_illustration(const std::string& base_illustration,
                              const std::filesystem::path& folder, const Illustration& kept);

/// The JSON Schema (draft 2020-12) of illustration files.
std::string illustration_schema();

}  // namespace burin
