// SPDX-License-Identifier: Apache-2.0
#include "results/regress/baseline.h"

#include "core/toml.h"
#include "core/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

constexpr int64_t kBaselineSchema = 1;

constexpr const char* kHead =
    "# Numbers that a regression suite compares with (docs/regress.md). Written by 'umbrameter regress "
    "record' and\n"
    "# 'umbrameter regress check --update --reason TEXT'; visibility errors are against physical truth, not "
    "pictures.\n";

std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

std::string reason_text(const BaselineReason& reason) {
  std::string changed;
  for (const std::string& what : reason.changed) changed += (changed.empty() ? "" : ", ") + toml_string(what);
  return fmt::format("\n[[reason]]\ndate = {}\ntext = {}\nversion = {}\nchanged = [{}]\n",
                     toml_string(reason.date), toml_string(reason.text), toml_string(reason.version),
                     changed);
}

std::string mean_text(const MeanWithNoise& mean) {
  return fmt::format("{{ value = {}, sd = {} }}", number(mean.value), number(mean.sd));
}

std::string truth_text(const TruthNumbers& truth) {
  return fmt::format(
      "[scene.truth]\nhash = {}\ndevice = {}\nseed = {}\nsamples_per_pixel = {}\nvisibility = {}\npenumbra = "
      "{}\n",
      toml_string(truth.hash), toml_string(truth.device), truth.seed, number(truth.samples_per_pixel),
      mean_text(truth.visibility), mean_text(truth.penumbra));
}

std::string run_text(const BaselineRun& run) {
  const CaseNumbers& n = run.numbers;
  const Interval rmse = rmse_of(n);
  std::string text = fmt::format(
      "\n[[scene.run]]\nlabel = {}\ntechnique = {}\nhash = {}\nparameters = {}\ndevice = {}\nscored_pixels = "
      "{}\n"
      "# RMSE {:.5f} [{:.5f}, {:.5f}]\n"
      "mse = {{ value = {}, low = {}, high = {}, noise_sd = {}, seed_sd = {} }}\n",
      toml_string(run.label), toml_string(run.technique), toml_string(run.hash), toml_string(run.parameters),
      toml_string(run.device), n.scored_pixels, rmse.value, rmse.low, rmse.high, number(n.mse.value),
      number(n.mse.low), number(n.mse.high), number(n.noise_sd), number(n.seed_sd));
  if (run.time)
    text += fmt::format("time = {{ median_ms = {}, mad_ms = {}, frames = {} }}\n",
                        number(run.time->median_ms), number(run.time->mad_ms), run.time->frames);
  if (n.measures.empty()) return text;
  text += "[scene.run.measures]\n";
  for (const auto& [name, value] : n.measures) text += fmt::format("{} = {}\n", name, number(value));
  return text;
}

uint64_t whole(TomlReader& reader, const std::string& key) {
  const int64_t value = reader.integer(key);
  if (value < 0) reader.fail(key, fmt::format("'{}' is {}, less than 0", key, value));
  return static_cast<uint64_t>(value);
}

double deviation(TomlReader& reader, const std::string& key) {
  const double value = reader.number(key);
  if (value < 0.0) reader.fail(key, fmt::format("'{}' is {}, less than 0", key, value));
  return value;
}

BaselineReason read_reason(const TomlNode& table) {
  TomlReader reader(table, "[[reason]]");
  BaselineReason reason = {reader.text("date"), reader.text("text"), reader.text("version"),
                           reader.texts("changed")};
  reader.finish();
  return reason;
}

MeanWithNoise read_mean(const TomlNode& table, const std::string& name) {
  TomlReader reader(table, name);
  const MeanWithNoise mean = {reader.number("value"), deviation(reader, "sd")};
  reader.finish();
  return mean;
}

TruthNumbers read_truth(const TomlNode& table) {
  TomlReader reader(table, "[scene.truth]");
  TruthNumbers truth;
  truth.hash = reader.text("hash");
  truth.device = reader.text("device");
  truth.seed = whole(reader, "seed");
  truth.samples_per_pixel = deviation(reader, "samples_per_pixel");
  truth.visibility = read_mean(reader.require("visibility"), "visibility");
  truth.penumbra = read_mean(reader.require("penumbra"), "penumbra");
  reader.finish();
  return truth;
}

void read_mse(const TomlNode& table, CaseNumbers& numbers) {
  TomlReader reader(table, "mse");
  numbers.mse = {reader.number("value"), reader.number("low"), reader.number("high")};
  numbers.noise_sd = deviation(reader, "noise_sd");
  numbers.seed_sd = deviation(reader, "seed_sd");
  reader.finish();
}

BaselineTime read_time(const TomlNode& table) {
  TomlReader reader(table, "time");
  const BaselineTime time = {deviation(reader, "median_ms"), deviation(reader, "mad_ms"),
                             static_cast<int>(whole(reader, "frames"))};
  reader.finish();
  return time;
}

BaselineRun read_run(const TomlNode& table) {
  TomlReader reader(table, "[[scene.run]]");
  BaselineRun run;
  run.label = reader.text("label");
  run.technique = reader.text("technique");
  run.hash = reader.text("hash");
  run.parameters = reader.text("parameters");
  run.device = reader.text("device");
  run.numbers.scored_pixels = whole(reader, "scored_pixels");
  read_mse(reader.require("mse"), run.numbers);
  if (const TomlNode* node = reader.find("time")) run.time = read_time(*node);
  if (const TomlNode* node = reader.find("measures")) {
    TomlReader measures(*node, "[scene.run.measures]");
    for (const std::string& name : measure_names()) {
      if (measures.has(name)) run.numbers.measures[name] = measures.number(name);
    }
    measures.finish();
  }
  reader.finish();
  return run;
}

BaselineScene read_scene(const TomlNode& table) {
  TomlReader reader(table, "[[scene]]");
  BaselineScene scene;
  scene.name = reader.text("name");
  scene.hash = reader.text("hash");
  scene.truth = read_truth(reader.require("truth"));
  for (const TomlNode* node : reader.tables("run")) {
    BaselineRun run = read_run(*node);
    if (scene.find(run.label) != nullptr)
      fail_input(fmt::format("two runs of '{}' are labelled '{}'", scene.name, run.label), node->where);
    put_run(scene, std::move(run));
  }
  reader.finish();
  return scene;
}

Baseline read_baseline(const TomlNode& root) {
  TomlReader reader(root, "the baseline");
  const int64_t schema = reader.integer("schema");
  if (schema != kBaselineSchema)
    reader.fail("schema", fmt::format("schema {} is not known", schema),
                fmt::format("this reads {}; record the baseline again", kBaselineSchema));
  Baseline baseline;
  baseline.suite = reader.text("suite");
  baseline.width_px = static_cast<int>(whole(reader, "width_px"));
  baseline.height_px = static_cast<int>(whole(reader, "height_px"));
  for (const TomlNode* node : reader.tables("reason")) baseline.reasons.push_back(read_reason(*node));
  for (const TomlNode* node : reader.tables("scene")) {
    baseline.scenes.push_back(read_scene(*node));
    const std::string& name = baseline.scenes.back().name;
    if (baseline.find(name) != &baseline.scenes.back())
      fail_input(fmt::format("scene '{}' is there twice", name), node->where);
  }
  reader.finish();
  return baseline;
}

}  // namespace

const BaselineRun* BaselineScene::find(const std::string& label) const {
  const auto found = std::ranges::find(runs, label, &BaselineRun::label);
  return found == runs.end() ? nullptr : &*found;
}

const BaselineScene* Baseline::find(const std::string& scene) const {
  const auto found = std::ranges::find(scenes, scene, &BaselineScene::name);
  return found == scenes.end() ? nullptr : &*found;
}

void put_run(BaselineScene& scene, BaselineRun run) {
  const auto place = std::ranges::lower_bound(scene.runs, run.label, {}, &BaselineRun::label);
  if (place != scene.runs.end() && place->label == run.label) {
    *place = std::move(run);
  } else {
    scene.runs.insert(place, std::move(run));
  }
}

std::string to_toml_text(const Baseline& baseline) {
  std::string text = kHead;
  text += fmt::format("schema = {}\nsuite = {}\nwidth_px = {}\nheight_px = {}\n", kBaselineSchema,
                      toml_string(baseline.suite), baseline.width_px, baseline.height_px);
  for (const BaselineReason& reason : baseline.reasons) text += reason_text(reason);
  std::vector<BaselineScene> scenes = baseline.scenes;
  std::ranges::sort(scenes, {}, &BaselineScene::name);
  for (const BaselineScene& scene : scenes) {
    text +=
        fmt::format("\n[[scene]]\nname = {}\nhash = {}\n", toml_string(scene.name), toml_string(scene.hash));
    text += truth_text(scene.truth);
    for (const BaselineRun& run : scene.runs) text += run_text(run);
  }
  return text;
}

Baseline parse_baseline(std::string_view document, const std::string& file) {
  return read_baseline(parse_toml(document, file));
}

Baseline load_baseline(const std::filesystem::path& path) {
  return read_baseline(parse_toml_file(path));
}

}  // namespace umbrameter
