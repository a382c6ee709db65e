#include "threads.h"

#include <burin/base/error.h>
#include <burin/threads/metric.h>
#include <burin/threads/unified.h>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

namespace burin::python {
namespace {

namespace py = pybind11;

[[noreturn]] void refuse(const std::string& what) {
  throw UsageError("a thread of a part " + what);
}

template <class T>
T value_of(const py::dict& thread, const char* key, const char* takes) {
  if (!thread.contains(key)) refuse(fmt::format("has \"{}\", {}", key, takes));
  try {
    return thread[key].cast<T>();
  } catch (const py::cast_error&) {
    refuse(fmt::format("takes as \"{}\" {}", key, takes));
  }
}

Vec3 vector_of(const py::dict& thread, const char* key) {
  const auto v = value_of<std::array<double, 3>>(thread, key, "three numbers");
  if (!std::isfinite(v[0] + v[1] + v[2]))
    refuse(fmt::format("takes finite numbers as \"{}\"", key));
  return {v[0], v[1], v[2]};
}

Thread thread_of(const py::dict& given) {
  static const std::set<std::string> known = {"size", "at", "along", "length", "internal"};
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key);
    if (!known.contains(name)) refuse(fmt::format("has no key \"{}\"", name));
  }
  Thread thread;
  thread.designation = value_of<std::string>(given, "size", "a text such as M6");
  const auto size = known_size(thread.designation);
  const auto pitch = size ? size->pitch ? size->pitch : coarse_pitch(size->diameter) : std::nullopt;
  if (!pitch) {
    refuse(
        fmt::format("takes a size such as M6, M6x0.75 or 1/4 UNC, not '{}'", thread.designation));
  }
  thread.major = 0.5 * size->diameter;
  thread.minor = 0.5 * minor_diameter(size->diameter, *pitch);
  const Vec3 along = vector_of(given, "along");
  if (along == Vec3(0)) refuse("takes as \"along\" a direction but 0, 0, 0");
  thread.axis = {vector_of(given, "at"), glm::normalize(along)};
  thread.end = value_of<double>(given, "length", "mm over 0");
  if (!(thread.end > 0 && thread.end <= 1e12)) refuse("takes as \"length\" mm over 0");
  thread.internal =
      !given.contains("internal") || value_of<bool>(given, "internal", "True or False");
  return thread;
}

}  // namespace

std::vector<Thread> threads_of(const py::sequence& given) {
  std::vector<Thread> out;
  for (const auto& one : given) {
    if (!py::isinstance<py::dict>(one)) refuse("is a mapping, {\"size\": \"M6\", ...}");
    out.push_back(thread_of(one.cast<py::dict>()));
  }
  return out;
}

py::list list_of(const std::vector<Thread>& threads) {
  py::list out;
  for (const Thread& thread : threads) {
    const Vec3 at = thread.axis.point + thread.begin * thread.axis.along;
    py::dict one;
    one["size"] = thread.designation;
    one["at"] = py::make_tuple(at.x, at.y, at.z);
    one["along"] = py::make_tuple(thread.axis.along.x, thread.axis.along.y, thread.axis.along.z);
    one["length"] = thread.end - thread.begin;
    one["internal"] = thread.internal;
    out.append(one);
  }
  return out;
}

}  // namespace burin::python
