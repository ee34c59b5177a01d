// SPDX-License-Identifier: Apache-2.0
// Without these a cause could be judged by error that a technique has anyway.
#include "study/selftest/causes.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace umbrameter {
namespace {

Image picture_of(const std::vector<float>& visibility) {
  Image image(static_cast<int>(visibility.size()), 1);
  std::ranges::copy(visibility, image.add_plane("visibility").begin());
  return image;
}

TEST(SelftestCauses, OnlyErrorThatWasPutInIsAFaultsOwn) {
  using enum FaultClass;
  const Image truth = picture_of({1.0f, 1.0f, 1.0f, 1.0f});
  const Image sound = picture_of({1.0f, 0.7f, 0.5f, 1.0f});
  const Image wrong = picture_of({0.8f, 0.3f, 0.1f, 0.5f});
  // The third is wrong by .9, of which the sound run has .5.
  EXPECT_THAT(put_in({acne, acne, acne, penumbra}, acne, wrong, sound, truth),
              testing::ElementsAre(acne, acne, explained, penumbra));
  EXPECT_THAT(put_in({explained, explained, explained, acne}, explained, wrong, sound, truth),
              testing::ElementsAre(explained, explained, penumbra, acne));
}

TEST(SelftestCauses, EveryCaseNamesWhatWasPutIn) {
  const std::vector<CauseCase> cases = cause_list();
  EXPECT_GE(cases.size(), 26u);
  for (const CauseCase& one : cases) {
    EXPECT_EQ(one.right.size(), 1u) << one.name;
    EXPECT_FALSE(one.wrong.empty() && one.patches.empty() && !one.change) << one.name;
  }
}

}  // namespace
}  // namespace umbrameter
