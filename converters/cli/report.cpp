#include "report.h"

#include <burin/base/error.h>
#include <burin/base/out_of_memory.h>
#include <burin/converters/messages.h>

#include "console.h"
#include "signals.h"

#include <exception>

namespace burin::cli {
namespace {

std::string said(const std::exception& e) { return at_door(e.what(), Spelling::Options); }

}  // namespace

int report(const std::string& input) {
  try {
    throw;
  } catch (const Cancelled&) {
    if (signals::may_say_cancelled()) print_error("cancelled");
    return kStopped;
  } catch (const UsageError& e) {
    print_error(said(e));
    return kUsage;
  } catch (const InputError& e) {
    print_error(located(e.file().empty() ? input : e.file(), e.line(), said(e)));
    return kBadInput;
  } catch (const GeometryError& e) {
    print_error(located(input, 0, said(e)));
    return kBadInput;
  } catch (const OutputError& e) {
    print_error(located(e.file(), 0, said(e)));
    return kNoOutput;
  } catch (const std::exception& e) {
    print_error(located(input, 0,
                        is_out_of_memory(e) ? "out of memory; draw a smaller model, or fewer at "
                                              "once"
                                            : said(e)));
    return kFailed;
  }
}

}  // namespace burin::cli
