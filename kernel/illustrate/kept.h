#pragma once
// What a stage made last, for as long as what it was made from stays the same; internal to the
// module.

#include <memory>
#include <optional>
#include <utility>

namespace burin::detail {

/// `Key`: all that the value depends on, comparable.
template <class Key, class Value>
class Kept {
 public:
  /// The value for a key: the last one, or what `make()` returns as a shared pointer. Where that
  /// throws nothing is kept.
  template <class Make>
  std::shared_ptr<Value> get(const Key& key, Make&& make) {
    if (key_ && *key_ == key) return value_;
    key_.reset();
    value_.reset();  // not two of them at once
    value_ = make();
    key_ = key;
    return value_;
  }

  /// What was made last; null where there is nothing.
  const Value* last() const { return value_.get(); }

 private:
  std::optional<Key> key_;
  std::shared_ptr<Value> value_;
};

}  // namespace burin::detail
