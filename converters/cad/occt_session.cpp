#include "occt_session.h"

#include <burin/base/error.h>

#include "text.h"

#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <OSD.hxx>
#include <OSD_Signal.hxx>
#include <STEPControl_Controller.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <fmt/format.h>

#include <array>
#include <iostream>

namespace burin {

/// Keeps the first message that is a complaint.
class MessageKeeper : public Message_Printer {
 public:
  DEFINE_STANDARD_RTTI_INLINE(MessageKeeper, Message_Printer)

 protected:
  void send(const TCollection_AsciiString& text, const Message_Gravity gravity) const override {
    if (gravity >= Message_Alarm && kept_.empty()) kept_ = clean_name(text.ToCString());
  }

 private:
  mutable std::string kept_;
  friend class OcctSession;
};

namespace {

/// OCCT's repair of what was read, but for one of its steps: where a hole touches the outline of
/// its face that moves their corners, and then takes the holes of the face for faces of their own,
/// discs that close them.
class Repair final : public ShapeAlgo_ToolContainer {
  Handle(ShapeFix_Shape) FixShape() const override {
    Handle(ShapeFix_Shape) fix = ShapeAlgo_ToolContainer::FixShape();
    fix->FixFaceTool()->FixIntersectingWiresMode() = 0;
    return fix;
  }
};

// Signals that OCCT's handlers are wanted for, and those that OSD::SetSignal takes as well.
constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGILL, SIGFPE};
constexpr std::array kOthers{SIGHUP, SIGINT, SIGQUIT, SIGSYS, SIGTERM, SIGPIPE, SIGALRM};

std::mutex& occt_mutex() {
  static std::mutex mutex;
  return mutex;
}

// Bytes for the handler of a signal.
constexpr std::size_t kHandlerStack = std::size_t{1} << 17;

void set_parameters() {
  STEPControl_Controller::Init();
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 0);
  XCAFDoc_ShapeTool::SetAutoNaming(Standard_False);
}

}  // namespace

OcctSession::OcctSession(Of of) : lock_(occt_mutex()), files_(of == Of::Files) {
  if (files_) take_messages();
  const auto keep = [](int signal) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    return std::pair(signal, action);
  };
  std::vector<std::pair<int, struct sigaction>> others;
  for (const int signal : kCrashes) handlers_.push_back(keep(signal));
  for (const int signal : kOthers) others.push_back(keep(signal));
  // No Ctrl-C may arrive while the handler for it is not ours.
  sigset_t all, before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  OSD::SetSignal(OSD_SignalMode_Set, Standard_False);
  for (const auto& [signal, action] : others) ::sigaction(signal, &action, nullptr);
  // A file whose entities refer to themselves lets OCCT run out of stack: its handler needs
  // another.
  stack_.resize(kHandlerStack);
  stack_t stack{};
  stack.ss_sp = stack_.data();
  stack.ss_size = stack_.size();
  ::sigaltstack(&stack, &stack_before_);
  struct sigaction crash {};
  ::sigaction(SIGSEGV, nullptr, &crash);
  crash.sa_flags |= SA_ONSTACK;
  ::sigaction(SIGSEGV, &crash, nullptr);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

void OcctSession::take_messages() {
  // Parts of OCCT print past its messengers.
  out_ = std::cout.rdbuf(nullptr);
  log_ = std::cerr.rdbuf(nullptr);
  auto& printers = Message::DefaultMessenger()->ChangePrinters();
  printers_ = printers;
  printers.Clear();
  messages_ = new MessageKeeper;
  printers.Append(messages_);
  set_parameters();
  ShapeAlgo::Init();
  repair_ = ShapeAlgo::AlgoContainer()->ToolContainer();
  ShapeAlgo::AlgoContainer()->SetToolContainer(new Repair);
}

OcctSession::~OcctSession() {
  for (const auto& [signal, action] : handlers_) ::sigaction(signal, &action, nullptr);
  ::sigaltstack(&stack_before_, nullptr);
  if (!files_) return;
  ShapeAlgo::AlgoContainer()->SetToolContainer(repair_);
  Message::DefaultMessenger()->ChangePrinters() = printers_;
  std::cout.rdbuf(out_);
  std::cerr.rdbuf(log_);
}

std::string OcctSession::first_message() const {
  return messages_.IsNull() ? std::string() : messages_->kept_;
}

void OcctSession::guarded(const std::string& file, const std::function<void()>& body) const {
  constexpr const char* kCrashed =
      "crashes the reader of OCCT; export the model again, or in another format";
  try {
    OCC_CATCH_SIGNALS
    body();
  } catch (const OSD_Signal&) {
    throw InputError(kCrashed, file);
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& e) {
    const std::string message = clean_name(e.GetMessageString());
    // Parts of OCCT catch the exception of a signal and throw one of their own.
    if (message.find("System Signal") != std::string::npos) throw InputError(kCrashed, file);
    throw InputError(fmt::format("cannot be read by OCCT ({}: {}); export the model again",
                                 e.DynamicType()->Name(), message),
                     file);
  }
}

}  // namespace burin
