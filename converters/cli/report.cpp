#include "report.h"

#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/base/out_of_memory.h>
#include <burin/converters/messages.h>

#include "console.h"
#include "signals.h"

#include <exception>

namespace burin::cli {
namespace {

std::string said(const std::exception& e) { return at_door(e.what(), Spelling::Options); }

}  // namespace

Failure failure_of(const std::string& input) {
  try {
    throw;
  } catch (const Cancelled&) {
    return {kStopped, "cancelled", "cancelled"};
  } catch (const UsageError& e) {
    return {kUsage, "usage", said(e)};
  } catch (const InputError& e) {
    const bool missing = dynamic_cast<const MissingFile*>(&e) != nullptr;
    return {kBadInput, missing ? "missing" : "input",
            located(e.file().empty() ? input : e.file(), e.line(), said(e))};
  } catch (const GeometryError& e) {
    return {kBadInput, "geometry", located(input, 0, said(e))};
  } catch (const OutputError& e) {
    return {kNoOutput, "output", located(e.file(), 0, said(e))};
  } catch (const std::exception& e) {
    if (!is_out_of_memory(e)) return {kFailed, "error", located(input, 0, said(e))};
    return {kFailed, "memory",
            located(input, 0, "out of memory; draw a smaller model, or fewer at once")};
  }
}

int report(const std::string& input) {
  const Failure failure = failure_of(input);
  if (failure.status != kStopped || signals::may_say_cancelled()) print_error(failure.message);
  return failure.status;
}

}  // namespace burin::cli
