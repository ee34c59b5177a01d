// SPDX-License-Identifier: Apache-2.0
#pragma once
// Embree's packets of 4, 8 and 16 rays behind one name.

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdint>

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

/// Lanes first .. first + Width - 1 of `rays`: origin, direction, extent and mask.
template <int Width>
typename ShadowPacket<Width>::Ray slice(const RTCRay16& rays, uint32_t first) {
  typename ShadowPacket<Width>::Ray part{};
  std::copy_n(rays.org_x + first, Width, part.org_x);
  std::copy_n(rays.org_y + first, Width, part.org_y);
  std::copy_n(rays.org_z + first, Width, part.org_z);
  std::copy_n(rays.dir_x + first, Width, part.dir_x);
  std::copy_n(rays.dir_y + first, Width, part.dir_y);
  std::copy_n(rays.dir_z + first, Width, part.dir_z);
  std::copy_n(rays.tnear + first, Width, part.tnear);
  std::copy_n(rays.tfar + first, Width, part.tfar);
  std::copy_n(rays.mask + first, Width, part.mask);
  return part;
}

}  // namespace umbrameter
