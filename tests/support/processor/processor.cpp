// Loaded before a command, has Embree take its code for the processor that BURIN_TEST_EMBREE names
// ("isa=sse2"), whatever processor there is.
#include <dlfcn.h>

#include <cstdlib>

// NOLINTNEXTLINE(readability-identifier-naming): the name is Embree's.
extern "C" void* rtcNewDevice(const char* configuration) {
  using NewDevice = void* (*)(const char*);
  const auto next = reinterpret_cast<NewDevice>(dlsym(RTLD_NEXT, "rtcNewDevice"));
  const char* named = std::getenv("BURIN_TEST_EMBREE");
  return next(named ? named : configuration);
}
