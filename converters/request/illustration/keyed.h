#pragma once
// What each key of an illustration file does, and what they read values with; internal to the
// module.

#include <burin/base/error.h>
#include <burin/converters/illustration.h>
#include <burin/options/json_lines.h>

#include "draw_options.h"
#include "keys.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin::detail {

using Json = nlohmann::ordered_json;

/// A value of JSON as options take it: lists with commas, with semicolons where they are of names
/// with commas.
std::string option_text(const Json& value);

/// The file that values stand in: what they may be, and errors that say where they are not that.
/// Paths are as JSON has them, "/parts/0/file".
class KeyedFile {
 public:
  KeyedFile(std::string_view text, std::string source);
  /// What stands in no text of a file, as a mark in a model: errors say "SOURCE: WHAT: ".
  static KeyedFile of_mark(const std::string& source, const std::string& what);

  const std::string& source() const { return source_; }
  std::int64_t line(const std::string& path) const { return lines_.line(path); }
  /// "FILE:LINE: ", or what stands for it.
  std::string place(const std::string& path) const;
  [[noreturn]] void fail(const std::string& path, const std::string& what) const;
  [[noreturn]] void unknown(const std::string& path, const std::string& key,
                            const std::vector<std::string>& known) const;

  /// An object with only known members.
  void check_object(const Json& value, const std::string& path) const;
  void check_array(const Json& value, const std::string& path) const;
  /// Never empty.
  std::string text(const Json& value, const std::string& path) const;
  /// One, or a list of them.
  std::vector<std::string> text_list(const Json& value, const std::string& path) const;
  bool flag(const Json& value, const std::string& path) const;
  double number(const Json& value, const std::string& path) const;
  /// `takes` is how people say the range.
  double within(const Json& value, const std::string& path, double least, double most,
                const char* takes) const;
  Vec3 vector(const Json& value, const std::string& path) const;
  /// Whether a value is of the types that its JSON Schema names; a whole number may be 1.0.
  void check_type(const Json& value, const std::string& path, const Json& schema) const;
  /// A key that an object has twice is an error.
  void check_repeated() const;

  /// The text of an object whose members stand in the lines that they have in the file, so that
  /// whoever reads it names these.
  std::string text_at_lines(const Json& object, const std::string& path) const;
  /// Of a file that is named from this one.
  std::string found_path(const std::string& name) const;
  /// Built-in styles by name; files as they are found from here.
  std::string style_named(const Json& value, const std::string& path) const;

  /// Asks the row of an option; its errors name the key and the line.
  template <class T>
  void check(const std::vector<RequestRow<T>>& rows, const std::string& option,
             const std::vector<std::string>& given, const std::string& path,
             const std::string& key) const {
    const auto row = std::ranges::find(rows, option, &RequestRow<T>::name);
    try {
      T scratch{};
      apply(std::vector<RequestRow<T>>{*row}, {{option, given}}, Spelling::Keywords, scratch);
    } catch (const UsageError& e) {
      std::string what = e.what();
      const std::string called = "argument " + option + " ";
      if (what.starts_with(called)) {
        what = fmt::format("\"{}\" {}", key, what.substr(called.size()));
      }
      fail(path, what);
    }
  }

 private:
  void write_at_lines(const Json& value, const std::string& path, std::string& out,
                      std::int64_t& line) const;

  std::string source_;
  std::filesystem::path folder_;
  JsonLines lines_;
  /// Instead of a line.
  std::string mark_ = {};
};

/// Which way a step goes: a unit vector.
Vec3 way_of(const KeyedFile& in, const Json& value, const std::string& path);
/// How far a step goes, model mm.
double distance_of(const KeyedFile& in, const Json& value, const std::string& path);
/// The number of an item.
int item_number(const KeyedFile& in, const std::string& text, const std::string& path);

/// Takes the value of a key into the illustration.
using TakeKey = void(const KeyedFile& in, const Json& value, const std::string& path,
                     IllustrationFile& out);

TakeKey take_parts, take_style, take_looks, take_lights, take_sections, take_explode, take_title,
    take_items, take_parts_list, take_breaks, take_details, take_threads, take_dimensions,
    take_notes, take_arrows, take_title_block;

/// What these keys take.
Json parts_schema();
Json looks_schema();
Json lights_schema();
Json section_schema();
Json explode_schema();
Json items_schema();
Json breaks_schema();
Json details_schema();
Json threads_schema();
Json notes_schema();
Json arrows_schema();
Json dimensions_schema();
Json title_block_schema();
/// A name, or the members of a style file.
Json style_value_schema();

/// What these keys say.
Json write_parts(const std::vector<IllustrationInput>& inputs);
Json write_looks(const std::vector<LookRequest>& looks);
Json write_lights(const std::vector<tone::Light>& lights);
Json write_explode(const Explode& explode);
Json write_items(const ItemNumbers& items);
Json write_arrows(const DrawRequest& request);
Json write_notes(const DrawRequest& request);
Json write_threads(const std::vector<ThreadRow>& threads, const Request& options);
/// Those that options say.
Json write_style(const Request& options);
Json write_sections(const Request& options);
Json write_dimensions(const DrawRequest& request);
Json write_title_block(const Request& options);
/// The text of an option as JSON has its values.
Json written_value(const RequestOption& option, const std::string& text);

}  // namespace burin::detail
