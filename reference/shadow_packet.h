#pragma once
// Embree's packets of 4, 8 and 16 rays behind one name.

#include <embree3/rtcore.h>

namespace umbrameter {

template <int Width>
struct ShadowPacket;
template <>
struct ShadowPacket<4> {
  using Ray = RTCRay4;
  static constexpr auto occluded = rtcOccluded4;
};
template <>
struct ShadowPacket<8> {
  using Ray = RTCRay8;
  static constexpr auto occluded = rtcOccluded8;
};
template <>
struct ShadowPacket<16> {
  using Ray = RTCRay16;
  static constexpr auto occluded = rtcOccluded16;
};

}  // namespace umbrameter
