// SPDX-License-Identifier: Apache-2.0
#pragma once
// PSNR and SSIM of one channel of the lit picture: second opinions beside FLIP, known to most readers.

#include "core/image.h"

#include <optional>
#include <string>

namespace umbrameter {

/// 10 log10(1 / mean squared difference) in dB, for values in [0,1]; infinite for equal pictures, absent for
/// an empty one. Error{input} on size mismatch, missing channel, NaN, values outside [0,1].
std::optional<double> measure_psnr_db(const Image& test, const Image& reference, const std::string& channel);

/// Mean structural similarity in [-1,1], 1 = equal (Wang, Bovik, Sheikh, Simoncelli 2004): Gaussian window of
/// 11 x 11 px and sigma 1.5, K1 = .01, K2 = .03, range 1, over windows that lie inside the picture; absent
/// when none does. Errors as above.
std::optional<double> measure_ssim(const Image& test, const Image& reference, const std::string& channel);

}  // namespace umbrameter
