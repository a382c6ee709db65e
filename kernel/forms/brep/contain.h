#pragma once
/// What OCCT throws ends here. Its exceptions are Standard_Failure and, from the standard library,
/// std::exception. While a caller has OCCT's handlers for signals set, as those who read files
/// have, a bad address inside OCCT becomes an OSD_Signal here and is passed on: what OCCT holds may
/// be broken. The jump out of the handler passes over destructors, so it has to be a short one.

#include <burin/base/error.h>

#include <OSD_Signal.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>

#include <exception>
#include <string>
#include <utility>

namespace burin {

/// Runs `work`; returns what OCCT had to say where it threw, empty where it did not. Burin's own
/// errors (Cancelled and the like are std::runtime_error) are passed on.
template <class Work>
std::string contained(Work&& work) {
  try {
    OCC_CATCH_SIGNALS
    work();
    return {};
  } catch (const OSD_Signal&) {
    throw;
  } catch (const Standard_Failure& failure) {
    const char* message = failure.GetMessageString();
    return message && *message ? message : failure.DynamicType()->Name();
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::logic_error& error) {
    return *error.what() ? error.what() : "unknown";
  }
}

/// As `contained`, and Burin's own errors end here too, save Cancelled: for work on one face or
/// edge that the others can do without.
template <class Work>
std::string survived(Work&& work) {
  try {
    return contained(work);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    return *error.what() ? error.what() : "unknown";
  }
}

/// The result of `work`, or `fallback` where OCCT threw.
template <class T, class Work>
T contained_or(T fallback, Work&& work) {
  T result = std::move(fallback);
  T made;
  if (contained([&] { made = work(); }).empty()) result = std::move(made);
  return result;
}

}  // namespace burin
