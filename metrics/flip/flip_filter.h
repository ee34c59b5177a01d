// SPDX-License-Identifier: Apache-2.0
#pragma once
// The filters of FLIP's observer: contrast sensitivity, edges and points, all separable.

#include <array>
#include <cstddef>
#include <vector>

namespace umbrameter {

/// Weights of taps 0..radius. Even: tap -k weighs what k does; odd: its negative, and tap 0 nothing.
using HalfKernel = std::vector<float>;

/// Blue-yellow is the sum of two separable Gaussians of one radius, whose shares its `columns` carry; smooth, edge and
/// point have one radius, too.
struct ObserverKernels {
  HalfKernel luminance, red_green;
  std::array<HalfKernel, 2> blue_yellow_rows, blue_yellow_columns;
  HalfKernel smooth, point;  // even: Gaussian and its second derivative
  HalfKernel edge;           // odd: the first derivative
  size_t radius = 0;         // of the widest
};

/// `ppd` pixels per degree.
ObserverKernels observer_kernels(double ppd);

/// Filtered values come in blocks of this many floats; rows are padded to it.
inline constexpr size_t kFilterBlock = 16;

/// The middle of an array of rows: along rows, row k is the same one shifted by k.
using Taps = const float* const*;

/// to[x] = sum over k of the tap k's weight times centre[k][x], for x < count (a multiple of kFilterBlock).
void filter_even(Taps centre, const HalfKernel& kernel, size_t count, float* to);

/// Two even kernels of one radius in one pass.
void filter_pair(Taps centre, const std::array<HalfKernel, 2>& kernels, size_t count,
                 const std::array<float*, 2>& to);

/// The odd edge and the even point in one pass; with the even smooth in the second.
void filter_derivatives(Taps centre, const ObserverKernels& kernels, size_t count, float* edge, float* point);
void filter_features(Taps centre, const ObserverKernels& kernels, size_t count, float* smooth, float* edge,
                     float* point);

}  // namespace umbrameter
