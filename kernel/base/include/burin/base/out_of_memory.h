#pragma once
/// Whether an error means that memory ran out, in our own code or in a library.

#include <cerrno>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

namespace burin {

/// std::bad_alloc; a thread that could not be made, by the standard library or by TBB, whose error
/// has only a text.
inline bool is_out_of_memory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  if (const auto* system = dynamic_cast<const std::system_error*>(&error)) {
    return system->code().value() == ENOMEM || system->code().value() == EAGAIN;
  }
  return std::string_view(error.what()).starts_with("pthread_create has failed");
}

}  // namespace burin
