// SPDX-License-Identifier: Apache-2.0
// Without these a verb could take an answer that is not its own, or lose one.

#include "lab/answers.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

class KeptAnswers : public testing::Test {
 protected:
  /// The number under the key; -1 where there is none.
  static int number(Answers& answers, const std::string& key) {
    int value = -1;
    answers.find(key, [&](const nlohmann::json& json) { value = json.at("number").get<int>(); });
    return value;
  }
  std::filesystem::path out() const { return folder_.path() / "out"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(KeptAnswers, AreThereForTheNextProcess) {
  {
    LazyStore store(out());
    Answers answers(store, true);
    EXPECT_EQ(number(answers, "a"), -1);
    EXPECT_FALSE(std::filesystem::exists(out())) << "looking leaves nothing behind";
    answers.keep("a", {{"number", 3}});
  }
  LazyStore store(out());
  Answers answers(store, true);
  EXPECT_EQ(number(answers, "a"), 3);
  EXPECT_EQ(number(answers, "b"), -1);
  EXPECT_EQ(answers.take_reused(), 1u);
  EXPECT_EQ(answers.take_reused(), 0u);
}

TEST_F(KeptAnswers, OfAnotherVersionAreNone) {
  LazyStore store(out());
  Answers answers(store, true);
  answers.keep("a", {{"value", 3}});
  EXPECT_FALSE(answers.find("a", [](const nlohmann::json& json) { json.at("number").get<int>(); }));
  EXPECT_EQ(answers.take_reused(), 0u);
}

TEST_F(KeptAnswers, AreNotFoundWithoutReuseAndReplaced) {
  LazyStore store(out());
  Answers answers(store, false), later(store, true);
  answers.keep("a", {{"number", 3}});
  EXPECT_EQ(number(answers, "a"), -1);
  answers.keep("a", {{"number", 4}});
  EXPECT_EQ(number(later, "a"), 4);
}

TEST_F(KeptAnswers, WithoutAStoreAreForgotten) {
  Answers answers;
  answers.keep("a", {{"number", 3}});
  EXPECT_FALSE(answers.keeps());
  EXPECT_EQ(number(answers, "a"), -1);
}

}  // namespace
}  // namespace umbrameter
