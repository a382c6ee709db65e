#pragma once
/// Embree 3 and 4 under one set of names; internal to the module. @cite Wald2014

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace burin::detail {

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;

inline void init(EmbreeContext& context) { rtcInitRayQueryContext(&context); }

inline void intersect(RTCScene scene, EmbreeContext& context, RTCRayHit& ray) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &ray, &arguments);
}

inline void occlude(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}
#else
using EmbreeContext = RTCIntersectContext;

inline void init(EmbreeContext& context) { rtcInitIntersectContext(&context); }

inline void intersect(RTCScene scene, EmbreeContext& context, RTCRayHit& ray) {
  rtcIntersect1(scene, &context, &ray);
}

inline void occlude(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
  rtcOccluded1(scene, &context, &ray);
}
#endif

}  // namespace burin::detail
