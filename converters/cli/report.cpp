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

std::string said(const std::exception& e, const std::string& input) {
  return error_message(e, Spelling::Options, input);
}

}  // namespace

Failure failure_of(const std::string& input) {
  try {
    throw;
  } catch (const Cancelled&) {
    return {kStopped, "cancelled", "cancelled"};
  } catch (const UsageError& e) {
    return {kUsage, "usage", said(e, input)};
  } catch (const InputError& e) {
    const bool missing = dynamic_cast<const MissingFile*>(&e) != nullptr;
    return {kBadInput, missing ? "missing" : "input", said(e, input)};
  } catch (const GeometryError& e) {
    return {kBadInput, "geometry", said(e, input)};
  } catch (const OutputError& e) {
    return {kNoOutput, "output", said(e, input)};
  } catch (const std::exception& e) {
    if (!is_out_of_memory(e)) return {kFailed, "error", said(e, input)};
    return {kFailed, "memory",
            located(input, 0, "out of memory; draw a smaller model, or fewer at once")};
  }
}

int report(const std::string& input) {
  const Failure failure = failure_of(input);
  if (failure.status != kStopped || signals::may_report_cancelled()) print_error(failure.message);
  return failure.status;
}

}  // namespace burin::cli
