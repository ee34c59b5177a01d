// SPDX-License-Identifier: Apache-2.0
// Without these tests the page could show other pixels than those that were measured, or put them where a page opened
// from disk cannot reach them.

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "core/error.h"
#include "core/files.h"
#include "core/image_io.h"
#include "report/page_data.h"
#include "report/plane_code.h"
#include "report/report.h"
#include "report/tune_files.h"
#include "results/json/results_json.h"
#include "results/pictures/picture_classes.h"
#include "results/pictures/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

TEST(ToHalf, IsTheNearestHalf) {
  EXPECT_EQ(to_half(0.0f), 0x0000);
  EXPECT_EQ(to_half(1.0f), 0x3C00);
  EXPECT_EQ(to_half(1.5f), 0x3E00);
  EXPECT_EQ(to_half(65504.0f), 0x7BFF);
  EXPECT_EQ(to_half(70000.0f), 0x7C00);
  EXPECT_EQ(to_half(0x1p-14f), 0x0400);         // smallest normal
  EXPECT_EQ(to_half(0x1p-24f), 0x0001);         // smallest subnormal
  EXPECT_EQ(to_half(1.0f + 0x1p-11f), 0x3C00);  // halfway: to even
  EXPECT_EQ(to_half(1.9999f), 0x4000);          // carries into the exponent
  EXPECT_EQ(to_half(std::nanf("")), 0x0000);
}

TEST(RangeCode, SpansTheFiniteValues) {
  const PlaneCode code = range_code(std::vector<float>{2.0f, -1.0f, std::numeric_limits<float>::infinity()});
  EXPECT_DOUBLE_EQ(code.low, -1.0);
  EXPECT_DOUBLE_EQ(code.low + 65535.0 * code.step, 2.0);
}

TEST(PictureClasses, ComeBackAsTheyWereDrawn) {
  const TemporaryFolder folder;
  std::vector<FaultClass> faults;
  for (size_t k = 0; k < kFaultClasses; ++k) faults.push_back(static_cast<FaultClass>(k));
  write_picture(folder.path() / "faults.png", fault_picture(faults, kFaultClasses, 1));
  EXPECT_EQ(read_fault_picture(folder.path() / "faults.png"), faults);
  EXPECT_THAT([&] { read_parity_picture(folder.path() / "faults.png"); },
              ThrowsMessage<Error>(HasSubstr("faults.png")));
}

TEST(ScriptSafe, CannotEndTheScript) {
  EXPECT_EQ(script_safe("\"</script><b>\""), "\"\\u003c/script>\\u003cb>\"");
}

class ReportFolder : public testing::Test {
 protected:
  void SetUp() override {
    write_file_atomically(folder_.path() / "results.json", to_json_text(fake_results(folder_.path())));
  }
  std::filesystem::path page() const { return folder_.path() / "report.html"; }
  TemporaryFolder folder_;
};

TEST_F(ReportFolder, PutsPixelsBeyondTheBudgetBesideThePage) {
  write_report(folder_.path(), page(), 0);
  EXPECT_THAT(read_file(folder_.path() / "report-data" / "s0-r1.js"), HasSubstr("take_planes(\"s0-r1\", {"));
  EXPECT_THAT(read_file(page()), Not(HasSubstr("id=\"s0-r1\"")));
  std::filesystem::remove_all(folder_.path() / "report-data");
  write_report(folder_.path(), page());
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "report-data"));
  EXPECT_THAT(read_file(page()), HasSubstr("id=\"s0-r1\""));
}

TEST_F(ReportFolder, ShowsBiasSweepsAndRefusesMalformedOnes) {
  const char* sweep =
      R"({"schema": 1, "technique": "pcf", "scenes": ["plate"], "bias_sweep": [{"parameter": "bias_texels", "unit": "texels",
          "is_complete": true, "has_window": true, "acne_free_from": {"texels": 0.5, "world": 0.005},
          "peter_pan_free_to": {"texels": 1, "world": 0.01}, "bias": [0, 1], "objective": [2, null],
          "acne_share": [1, 0], "peter_panning_share": [0, 1]}]})";
  write_file_atomically(folder_.path() / "tune-pcf.json", sweep);
  write_report(folder_.path(), page());
  EXPECT_THAT(read_file(page()), HasSubstr(R"("parameter":"bias_texels")"));
  EXPECT_THAT(read_file(page()), HasSubstr(R"("window":{"empty":false,"low":0.5,"high":1.0})"));
  write_file_atomically(folder_.path() / "tune-bad.json", R"({"schema": 1, "bias_sweep": {"parameter": 3}})");
  EXPECT_THAT([&] { write_report(folder_.path(), page()); },
              ThrowsMessage<Error>(HasSubstr("tune-bad.json")));
}

}  // namespace
}  // namespace umbrameter
