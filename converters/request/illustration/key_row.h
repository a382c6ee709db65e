#pragma once
// Members of the objects of an illustration file: a row each, from which these objects are read,
// written and described; internal to the module.

#include "json_schema.h"
#include "keyed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// What a member says of a T.
template <class T>
struct KeyRow {
  std::string name;
  /// The JSON Schema of its values.
  Json schema;
  /// Sets what a value says, at a path of the file.
  std::function<void(const KeyedFile& in, const Json& value, const std::string& path, T& to)> read;
  /// The value that says it; null: nothing is to be said. Absent: nobody writes the member.
  std::function<Json(const T&)> write = {};
  /// What errors say where the member is missing, {} for its name; empty: it may be.
  std::string missing = {};
};

template <class T>
std::vector<std::string> names_of(const std::vector<KeyRow<T>>& rows) {
  std::vector<std::string> names;
  for (const KeyRow<T>& row : rows) names.push_back(row.name);
  return names;
}

/// Throws UsageError where something is no object, or has other members, or lacks one.
template <class T>
void check_members(const std::vector<KeyRow<T>>& rows, const KeyedFile& in, const Json& object,
                   const std::string& path) {
  in.check_object(object, path);
  for (const auto& [key, ignored] : object.items()) {
    const auto row = std::ranges::find(rows, key, &KeyRow<T>::name);
    if (row == rows.end()) in.unknown(path + "/" + key, key, names_of(rows));
  }
  for (const KeyRow<T>& row : rows) {
    if (row.missing.empty() || object.contains(row.name)) continue;
    in.fail(path, fmt::format(fmt::runtime(row.missing), row.name));
  }
}

/// In the order of the rows, once `check_members` has nothing against it.
template <class T>
void read_members(const std::vector<KeyRow<T>>& rows, const KeyedFile& in, const Json& object,
                  const std::string& path, T& to) {
  for (const KeyRow<T>& row : rows) {
    if (object.contains(row.name)) row.read(in, object[row.name], path + "/" + row.name, to);
  }
}

/// Both.
template <class T>
T read_object(const std::vector<KeyRow<T>>& rows, const KeyedFile& in, const Json& object,
              const std::string& path, T start = {}) {
  check_members(rows, in, object, path);
  read_members(rows, in, object, path, start);
  return start;
}

template <class T>
Json write_object(const std::vector<KeyRow<T>>& rows, const T& from) {
  Json object = Json::object();
  for (const KeyRow<T>& row : rows) {
    Json value = row.write ? row.write(from) : Json();
    if (!value.is_null()) object[row.name] = std::move(value);
  }
  return object;
}

template <class T>
Json object_schema(const std::vector<KeyRow<T>>& rows) {
  Json properties = Json::object(), required = Json::array();
  for (const KeyRow<T>& row : rows) {
    properties[row.name] = row.schema;
    if (!row.missing.empty()) required.push_back(row.name);
  }
  Json schema = object_of(std::move(properties));
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

/// A direction, or a place of the model where `place` is true; not written where it is absent.
template <class T>
KeyRow<T> vector_row(const char* name, const char* meaning, std::optional<Vec3> T::*member,
                     bool place) {
  return {
      .name = name,
      .schema = vector_of(meaning),
      .read = [member, place](
                  const KeyedFile& in, const Json& value, const std::string& path,
                  T& to) { to.*member = place ? in.vector(value, path) : way_of(in, value, path); },
      .write =
          [member](const T& from) {
            const std::optional<Vec3>& v = from.*member;
            return v ? Json{v->x, v->y, v->z} : Json();
          }};
}

/// A length over 0 and up to `most`, model mm; not written where it is absent.
template <class T>
KeyRow<T> positive_row(const char* name, const char* meaning, std::optional<double> T::*member,
                       double most) {
  constexpr double kLeast = 1e-9;
  return {
      .name = name,
      .schema = {{"description", meaning},
                 {"type", "number"},
                 {"minimum", kLeast},
                 {"maximum", most}},
      .read = [member, most](
                  const KeyedFile& in, const Json& value, const std::string& path,
                  T& to) { to.*member = in.within(value, path, kLeast, most, "mm over 0"); },
      .write = [member](const T& from) { return from.*member ? Json(*(from.*member)) : Json(); }};
}

/// Rows that a list may have.
inline constexpr std::size_t kMostRows = 1000;

/// Calls `take(row, path of the row)` for each row of a list, or for the one that stands in its
/// place. Throws UsageError where the list is longer than `kMostRows`.
template <class Take>
void for_rows(const KeyedFile& in, const Json& value, const std::string& path, const Take& take) {
  if (!value.is_array()) return take(value, path);
  if (value.size() > kMostRows) {
    in.fail(path, fmt::format("\"{}\" takes {} rows at the most", path.substr(path.rfind('/') + 1),
                              kMostRows));
  }
  for (std::size_t i = 0; i < value.size(); ++i) take(value[i], fmt::format("{}/{}", path, i));
}

/// A flag; not written where it is absent.
template <class T>
KeyRow<T> flag_row(const char* name, const char* meaning, std::optional<bool> T::*member) {
  return {
      .name = name,
      .schema = flag(meaning),
      .read = [member](const KeyedFile& in, const Json& value, const std::string& path,
                       T& to) { to.*member = in.flag(value, path); },
      .write = [member](const T& from) { return from.*member ? Json(*(from.*member)) : Json(); }};
}

/// Text that is not empty; not written where it is.
template <class T>
KeyRow<T> text_row(const char* name, const char* meaning, std::string T::*member) {
  return {
      .name = name,
      .schema = text(meaning),
      .read = [member](const KeyedFile& in, const Json& value, const std::string& path,
                       T& to) { to.*member = in.text(value, path); },
      .write =
          [member](const T& from) { return (from.*member).empty() ? Json() : Json(from.*member); }};
}

}  // namespace burin::detail
