#pragma once
// Factories of plug-ins as rows of the catalogues.

#include <burin/base/plugin_error.h>
#include <burin/camera/camera.h>
#include <burin/plugin.h>
#include <burin/surface/visible_surfaces.h>

#include <memory>
#include <mutex>
#include <string>

namespace burin::plugin {

/// A factory and the file that it came from.
struct Source {
  const burin_factory* factory;
  std::string file;

  template <class T>
  const T& functions() const {
    return *static_cast<const T*>(factory->functions);
  }
};

/// Adds the row. Throws UsageError where a name of our own is in the way.
void add_direction(const Source& source);
void add_law(const Source& source);
void add_marks(const Source& source);
void add_form(const Source& source);
void add_reader(const Source& source);
void add_writer(const Source& source);
void add_symbol(const Source& source);
/// That of a factory of writers.
const char* suffix_of(const burin_factory& f);

/// Throws PluginError: "the direction 'spiral' (FILE) WHAT".
[[noreturn]] void fail(PluginError::Row row, const Source& source, const std::string& what);
/// The same where a function of it gave a code other than BURIN_OK.
void check(PluginError::Row row, const Source& source, std::int32_t code, const burin_error& error);

/// The message of a plug-in as one line; empty where it wrote none.
std::string message_of(const burin_error& error);

/// The errors of a call that follows are its own.
inline void clear(burin_error& error) {
  error.line = 0;
  error.message[0] = '\0';
}

burin_view view_of(const Camera& camera, const VisibleSurfaces& shown, Vec3 to_light, Vec3 axis);

/// What `make` of a factory made. Shared by all threads of a drawing.
class Self {
 public:
  Self(void* self, void (*destroy)(void*), bool one_thread)
      : self_(self),
        destroy_(destroy),
        mutex_(one_thread ? std::make_unique<std::mutex>() : nullptr) {}
  ~Self() {
    if (destroy_ != nullptr) destroy_(self_);
  }
  Self(const Self&) = delete;
  Self& operator=(const Self&) = delete;

  /// Calls a function with it; one thread at a time where the plug-in wants that.
  template <class Call>
  std::int32_t call(const Call& call) const {
    if (mutex_ == nullptr) [[likely]]
      return call(self_);
    const std::lock_guard lock(*mutex_);
    return call(self_);
  }

 private:
  void* self_;
  void (*destroy_)(void*);
  std::unique_ptr<std::mutex> mutex_;
};

}  // namespace burin::plugin
