#pragma once
/// What a reader needs of OCCT's process-wide state.

#include <burin/base/run_context.h>

#include <Message_ProgressIndicator.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <ShapeAlgo_ToolContainer.hxx>

#include <csignal>
#include <functional>
#include <mutex>
#include <streambuf>
#include <vector>

namespace burin {

class MessageKeeper;

/// As long as it lives this thread alone reads: OCCT's readers share parameters and caches. Its
/// messages are not printed, lengths come in mm, and the four signals of a crash are exceptions
/// inside `guarded`.
class OcctSession {
 public:
  /// Shapes: no file is exchanged. Parameters and the program's streams stay as they are, for
  /// another user of OCCT in this process (FreeCAD) may be at work.
  enum class Of { Files, Shapes };

  explicit OcctSession(Of of = Of::Files);
  ~OcctSession();
  OcctSession(const OcctSession&) = delete;
  OcctSession& operator=(const OcctSession&) = delete;

  /// Runs `body`, which reads `file`. Whatever OCCT throws, or a signal of a crash in it, becomes
  /// an InputError.
  void guarded(const std::string& file, const std::function<void()>& body) const;
  /// The first thing that OCCT complained of, or empty.
  std::string first_message() const;

 private:
  void take_messages();

  std::unique_lock<std::mutex> lock_;
  bool files_;
  std::streambuf *out_ = nullptr, *log_ = nullptr;
  Message_SequenceOfPrinters printers_;
  Handle(MessageKeeper) messages_;
  Handle(ShapeAlgo_ToolContainer) repair_;  // of before
  std::vector<std::pair<int, struct sigaction>> handlers_;
  std::vector<char> stack_;
  stack_t stack_before_{};
};

/// Progress of OCCT's algorithms into a share of the present stage, and their cancellation.
class OcctProgress : public Message_ProgressIndicator {
 public:
  OcctProgress(RunContext& context, double from, double to)
      : context_(context), from_(from), to_(to) {}
  Standard_Boolean UserBreak() override { return context_.cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    context_.progress(from_ + (to_ - from_) * GetPosition());
  }

 private:
  RunContext& context_;
  double from_, to_;
};

}  // namespace burin
