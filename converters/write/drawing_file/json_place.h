#pragma once
/// Values of JSON with the place where they stand, for readers that say what is wrong where.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace burin {

/// A value by its key or index in the one that holds it. Points to the holder: for the stack alone.
class JsonPlace {
 public:
  using Json = nlohmann::json;

  explicit JsonPlace(const Json& value) : value_(value) {}
  JsonPlace(const Json& value, const JsonPlace& parent, const char* key)
      : value_(value), parent_(&parent), key_(key) {}
  JsonPlace(const Json& value, const JsonPlace& parent, std::size_t index)
      : value_(value), parent_(&parent), index_(index) {}
  /// A value that stands at `place` in a document that is no longer whole.
  JsonPlace(const Json& value, std::string place) : value_(value), root_(std::move(place)) {}

  const Json& value() const { return value_; }
  std::size_t size() const { return value_.size(); }
  /// "layers[3].paths[17].points".
  std::string where() const;
  /// Throws InputError, without a file: "layers[3].name: takes text".
  [[noreturn]] void fail(const std::string& what) const;

  /// Calls `read(place)` for a member that is there and not null.
  template <class F>
  void optional(const char* key, const F& read) const {
    const auto it = value_.find(key);
    if (it != value_.end() && !it->is_null()) read(JsonPlace(*it, *this, key));
  }
  /// The same for a member that must be there.
  template <class F>
  void required(const char* key, const F& read) const {
    const auto it = value_.find(key);
    if (it == value_.end()) fail(std::string("lacks \"") + key + "\"");
    read(JsonPlace(*it, *this, key));
  }
  /// Calls `read(place, index)` for each element of a list.
  template <class F>
  void each(const F& read) const {
    if (!value_.is_array()) fail("takes a list [...]");
    std::size_t i = 0;
    for (const Json& element : value_) {
      read(JsonPlace(element, *this, i), i);
      ++i;
    }
  }
  /// Sets `out` by a member that is there and not null.
  template <class T>
  void member(const char* key, T& out) const {
    optional(key, [&](const JsonPlace& at) { at.set(out); });
  }
  /// Calls `read(place, index)` for each element of a list that is there and not null.
  template <class F>
  void each_of(const char* key, const F& read) const {
    optional(key, [&](const JsonPlace& list) { list.each(read); });
  }

  void check_object() const {
    if (!value_.is_object()) fail("takes an object {...}");
  }
  void set(std::string& out) const;
  void set(bool& out) const;
  /// Any finite number.
  void set(double& out) const;
  void set(std::int32_t& out) const;
  void set(std::int64_t& out) const;
  void set(std::uint32_t& out) const;
  void set(std::uint64_t& out) const;
  /// As many finite numbers as `Vec` has.
  template <class Vec>
  requires requires { Vec::length(); }
  void set(Vec& out) const {
    if (!value_.is_array() || value_.size() != static_cast<std::size_t>(Vec::length())) {
      fail("takes " + std::to_string(Vec::length()) + " numbers [...]");
    }
    for (int i = 0; i < Vec::length(); ++i) {
      JsonPlace(value_[static_cast<std::size_t>(i)], *this, static_cast<std::size_t>(i))
          .set(out[i]);
    }
  }

 private:
  void append_to(std::string& out) const;

  const Json& value_;
  const JsonPlace* parent_ = nullptr;
  const char* key_ = nullptr;
  std::size_t index_ = 0;
  std::string root_;
};

}  // namespace burin
