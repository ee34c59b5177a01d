// SPDX-License-Identifier: Apache-2.0
// Without these tests a second validation could render everything again, give other numbers than the first, show a
// damaged image, or skip something that would have changed a number.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <iostream>
#include <sstream>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

constexpr int kPatience_s = 1500;

class Reuse : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  /// stdout of 'validate --json' into out/.
  Json validate(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {"validate", "--json", "--width", "64", "--height", "36", "--spp", "16"});
    ProcessOptions options;
    options.timeout_s = kPatience_s;
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult result = umbrameter(arguments, options);
    wall_time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    err = result.err;
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out) : Json::object();
  }

  std::string read(const fs::path& name) const {
    std::ifstream file(folder() / name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path object_of(const std::string& image) const {
    for (const auto& entry : fs::recursive_directory_iterator(folder() / "out" / "objects")) {
      if (fs::equivalent(entry.path(), folder() / "out" / image)) return entry.path();
    }
    return {};
  }

  double wall_time_s = 0.0;
  std::string err;
};

Json without_work(Json results) {
  results.erase("work");
  return results;
}

TEST_F(Reuse, ASecondValidationOfTheLibraryRendersNothing) {
  const Json first = validate({"--frames", "1"});
  const Json& work = first["work"];
  EXPECT_GT(work["rendered"], 200);
  EXPECT_EQ(work["references_rendered"], first["scenes"].size());
  EXPECT_EQ(work["reused"], 0);
  const std::string results = read("out/results.json");
  const auto page_time = fs::last_write_time(folder() / "out" / "report.html");
  const double first_s = wall_time_s;

  const Json second = validate({"--frames", "1"});
  EXPECT_EQ(second["work"]["rendered"], 0);
  EXPECT_EQ(second["work"]["references_rendered"], 0);
  EXPECT_EQ(second["work"]["reused"], work["rendered"]);
  EXPECT_EQ(second["work"]["references_reused"], work["references_rendered"]);
  EXPECT_EQ(without_work(second), without_work(first));
  EXPECT_EQ(read("out/results.json"), results);
  EXPECT_EQ(fs::last_write_time(folder() / "out" / "report.html"), page_time) << "written again for nothing";
  for (const Json& scene : second["scenes"]) {
    for (const Json& run : scene["techniques"])
      EXPECT_TRUE(fs::exists(folder() / "out" / run["picture_file"].get<std::string>())) << run["label"];
  }
  std::cout << work["rendered"] << " runs: first " << first_s << " s, again " << wall_time_s << " s\n";
}

TEST_F(Reuse, AnAlteredImageIsFoundAndMadeAgain) {
  const std::vector<std::string> arguments{"plate", "--technique", "hard", "--technique", "pcf"};
  const Json first = validate(arguments);
  const fs::path image = object_of("images/plate/pcf.exr");
  ASSERT_FALSE(image.empty());
  std::ofstream(image, std::ios::binary | std::ios::app) << "x";
  const Json again = validate(arguments);
  EXPECT_THAT(err, HasSubstr("its image was altered; it is made again"));
  EXPECT_EQ(again["work"]["rendered"], 1);
  EXPECT_EQ(again["work"]["reused"], 1);
  const auto errors = [](const Json& results) {
    Json list;
    for (const Json& run : results["scenes"][0]["techniques"])
      list.push_back({run["error"], run["verdict"], run["faults"]});
    return list;
  };
  EXPECT_EQ(errors(again), errors(first));
}

TEST_F(Reuse, WhatIsNewIsMeasuredAgainstWhatIsStored) {
  validate({"plate", "--technique", "hard"});
  const Json both = validate({"plate", "--technique", "hard", "--technique", "pcf"});
  EXPECT_EQ(both["work"]["rendered"], 1);
  EXPECT_EQ(both["work"]["references_rendered"], 0);
  const Json anew = validate({"plate", "--technique", "hard", "--technique", "pcf", "--no-reuse"});
  EXPECT_EQ(anew["work"]["rendered"], 2);
  for (const size_t run : {0u, 1u}) {
    const Json &one = both["scenes"][0]["techniques"][run], &other = anew["scenes"][0]["techniques"][run];
    for (const char* key : {"error", "significance", "verdict", "faults"})
      EXPECT_EQ(one[key], other[key]) << key;
  }
  EXPECT_TRUE(both["scenes"][0]["techniques"][1]["verdict"].is_object());
}

/// What a validation says of shadows: no times, no counts of samples, no list of what was left out.
Json numbers_of(const Json& results) {
  Json numbers;
  for (const Json& scene : results["scenes"]) {
    for (const Json& run : scene["techniques"]) {
      Json one;
      for (const char* key :
           {"error", "significance", "penumbra", "contact_hardening", "faults", "moire", "causes"})
        one[key] = run[key];
      if (run["verdict"].is_object())
        one["outcome"] = {run["verdict"]["outcome"], run["verdict"]["mse_difference"]};
      numbers[scene["name"].get<std::string>()][run["label"].get<std::string>()] = one;
    }
    numbers[scene["name"].get<std::string>()]["parity"] = scene["parity"]["agreement"];
  }
  return numbers;
}

TEST_F(Reuse, SkippingChangesNoNumberOfTheLibrary) {
  const Json skipping = validate({"--frames", "0"});
  const Json all = validate({"--frames", "0", "--no-skip", "--no-reuse"});
  const Json one = numbers_of(skipping), other = numbers_of(all);
  ASSERT_EQ(one.size(), skipping["scenes"].size());
  for (const auto& [scene, runs] : other.items()) {
    for (const auto& [label, numbers] : runs.items())
      EXPECT_EQ(one[scene][label], numbers) << scene << ", " << label;
  }
  size_t with_saving = 0, proven = 0;
  for (const Json& skip : skipping["skipped"]) {
    EXPECT_FALSE(skip["reason"].get<std::string>().empty());
    with_saving += skip["saved_s"].is_number() ? 1 : 0;
    proven += skip["technique"] == "" ? 1 : 0;
  }
  EXPECT_GT(with_saving, 0u);
  EXPECT_GT(proven, 5u);
  for (const Json& skip : all["skipped"]) {
    if (!other.contains(skip["scene"].get<std::string>())) continue;  // without its models
    EXPECT_NE(skip["technique"], "") << "skipped in spite of --no-skip: " << skip["reason"];
  }
}

TEST_F(Reuse, AValidationAndASweepOfTheSameRunsRenderThemOnce) {
  write("study.toml",
        "schema = 1\ntitle = \"Two\"\nscenes = [\"plate\"]\nwidth_px = 64\nheight_px = 36\n"
        "samples_per_pixel = 16\nframes = 1\n[[run]]\ntechnique = \"hard\"\n[[run]]\ntechnique = \"pcf\"\n");
  const auto sweep = [&](const std::string& store) {
    const ProcessResult result = umbrameter({"sweep", "study.toml", "--time", "--json", "--out", store});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out);
  };
  const auto validate_into = [&](const std::string& store) {
    return validate({"plate", "--technique", "hard", "--technique", "pcf", "--quality", "quick", "--frames",
                     "1", "--causes", "none", "--out", store});
  };
  const auto verdict_of = [&](const std::string& store) {
    const ProcessResult result = umbrameter({"export", store, "--json"});
    const Json exported = Json::parse(result.out), &runs = exported["runs"];
    EXPECT_EQ(runs.size(), 2u);
    for (const Json& run : runs)
      if (run["result"]["label"] == "pcf") return run["result"]["verdict"]["mse_difference"];
    return Json();
  };
  EXPECT_EQ(sweep("swept")["rendered"], 2);
  const Json after = validate_into("swept");
  EXPECT_EQ(after["work"]["rendered"], 0);
  EXPECT_EQ(after["work"]["references_rendered"], 0);
  const Json alone = validate_into("validated");
  EXPECT_EQ(alone["work"]["rendered"], 2);
  EXPECT_EQ(numbers_of(after), numbers_of(alone));
  for (size_t i = 0; i < 2; ++i) {
    for (const char* picture : {"picture_file", "error_picture_file", "fault_picture_file"}) {
      const std::string file = after["scenes"][0]["techniques"][i][picture];
      ASSERT_FALSE(file.empty()) << picture;
      EXPECT_EQ(read("swept/" + file), read("validated/" + file)) << file;
    }
  }
  const std::string parity = after["scenes"][0]["parity"]["picture_file"];
  EXPECT_EQ(read("swept/" + parity), read("validated/" + parity));

  const Json swept = sweep("validated");
  EXPECT_EQ(swept["rendered"], 0);
  EXPECT_EQ(swept["reused"], 2);
  EXPECT_TRUE(verdict_of("validated").is_object());
  EXPECT_EQ(verdict_of("validated"), verdict_of("swept"));
  EXPECT_EQ(validate_into("validated")["work"]["rendered"], 0);
  EXPECT_EQ(validate_into("swept")["work"]["rendered"], 0);

  std::string study = read("study.toml");
  study.replace(study.find("frames = 1\n"), 11, "frames = 9\n");
  write("study.toml", study);
  EXPECT_EQ(sweep("validated")["rendered"], 2) << "one frame was stored, nine are wanted";
  EXPECT_EQ(sweep("validated")["rendered"], 0);
}

}  // namespace
}  // namespace umbrameter
