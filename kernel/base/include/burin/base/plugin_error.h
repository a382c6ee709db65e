#pragma once
/// A plug-in that fails while it is used.

#include <burin/base/error.h>

#include <string>
#include <utility>

namespace burin {

/// Thrown by what a plug-in or a program added. A drawing goes on without it: where that can be,
/// with what Burin has in its place.
class PluginError : public Error {
 public:
  /// What it is a row of, for messages, and how a user asks for it.
  enum class Row { Direction, Law, StrokeKind, Form, Reader, Writer, Symbol };

  PluginError(Row row, std::string name, const std::string& what)
      : Error(what), row_(row), name_(std::move(name)) {}
  Row row() const { return row_; }
  const std::string& name() const { return name_; }

 private:
  Row row_;
  std::string name_;
};

}  // namespace burin
