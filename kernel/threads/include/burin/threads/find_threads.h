#pragma once
/// The faces of a part that have a thread.

#include <burin/base/run_context.h>
#include <burin/surface/surface.h>
#include <burin/surface/thread.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What is asked of a thread, model mm. Diameters of 0 are not known.
struct WantedThread {
  double diameter = 0, pitch = 0, minor = 0;
  /// "M6"; empty: by the diameter.
  std::string designation = {};
  /// The cylinder next to this point, or of this number; else all that the diameters fit.
  std::optional<Vec3> at = {};
  std::optional<std::int32_t> face = {};
  /// From the open end (next to `at`), and how long; absent: as far as the cylinder goes.
  double start = 0;
  std::optional<double> length = {};
};

struct FoundThreads {
  std::vector<Thread> threads;
  /// Why there is none: "no shaft of 6 mm and no hole of 4.9 to 5.7 or 6 mm"; else empty.
  std::string missing;
  /// Why one is shorter than wanted: "its cylinder ends after 20 mm"; else empty.
  std::string shorter = {};
  /// The diameters of which ISO 261 has no coarse thread; the minor one is then 0.85 of them.
  std::vector<double> without_table;
};

/// Looks at the cylinders of one surface: faces, or several about one axis with one radius, that go
/// more than half the way round. Built once; realises no form.
class ThreadFinder {
 public:
  /// The surface must outlive it. Cost: that of `turned_faces`, and of a tree of rays.
  ThreadFinder(const Surface& surface, const RunContext& context);
  ~ThreadFinder();

  /// Shafts as wide as the major diameter (within 1.5 %) have a thread; so have holes of 0.985
  /// times the minor diameter up to three quarters of the way to the major one, and those as wide
  /// as that (within 0.5 %).
  FoundThreads find(const WantedThread& wanted) const;
  /// A thread that an input tells with its axis, on the face that it is on; nothing where no
  /// cylinder of such a radius has that axis.
  std::optional<Thread> settled(const Thread& told) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
