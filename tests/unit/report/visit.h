// SPDX-License-Identifier: Apache-2.0
#pragma once
// A report opened from disk in a real browser that gets real keys and pointers.

#include "tests/support/temporary_folder.h"

#include "report/plane_store.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace umbrameter {

/// Steps of tests/support/browser.py.
nlohmann::json evaluate(const std::string& script);
nlohmann::json press(const std::string& key);
/// What is drawn is drawn with the next frame.
nlohmann::json next_frame();
/// Shows run `run` of scene 0 against the reference and resolves when it is drawn; the viewer has the focus then.
std::string ready(int run);

/// Of the page of fake_results. Skipped without a browser.
class ReportVisit : public testing::Test {
 protected:
  void SetUp() override;

  /// Writes the page and takes the steps: {console, values, load_ms}; values without those that are null.
  nlohmann::json visit(const nlohmann::json& steps, size_t budget_bytes = kPageBudget_bytes);
  std::filesystem::path place(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

}  // namespace umbrameter
