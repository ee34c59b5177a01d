// SPDX-License-Identifier: Apache-2.0
#include "study/study_file.h"

#include "core/names.h"
#include "study/run_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

constexpr int64_t kStudySchema = 1;
constexpr int64_t kMaxFrames = 10000;

const std::array<std::string, 3> kClaimPictures{"other", "same", "either"};

std::optional<int64_t> positive(TomlReader& reader, const std::string& key) {
  if (!reader.has(key)) return std::nullopt;
  const int64_t value = reader.integer(key);
  if (value < 1) reader.fail(key, fmt::format("'{}' is {}, not 1 or more", key, value));
  return value;
}

/// Each of the list `key` once, or an error that calls it a `what`.
void require_different(const TomlReader& reader, const std::string& key, const std::string& what,
                       const std::vector<std::string>& texts) {
  for (auto text = texts.begin(); text != texts.end(); ++text) {
    if (std::find(texts.begin(), text, *text) != text)
      reader.fail(key, fmt::format("{} '{}' is given twice", what, *text));
  }
}

std::vector<uint64_t> read_seeds(TomlReader& reader) {
  const TomlNode* node = reader.find("seeds");
  if (node == nullptr) return {1};
  if (node->type != TomlNode::Type::array || node->items.empty())
    reader.fail("seeds", "'seeds' is no list of whole numbers");
  std::vector<uint64_t> seeds;
  for (const TomlNode& item : node->items) {
    if (item.type != TomlNode::Type::integer || item.integer < 0)
      fail_input("a seed is not a whole number of 0 or more", item.where);
    const auto seed = static_cast<uint64_t>(item.integer);
    if (std::ranges::find(seeds, seed) != seeds.end())
      fail_input(fmt::format("seed {} is given twice", seed), item.where);
    seeds.push_back(seed);
  }
  return seeds;
}

double positive_number(const TomlNode& node, const std::string& what) {
  const bool is_number = node.type == TomlNode::Type::integer || node.type == TomlNode::Type::real;
  if (!is_number || !std::isfinite(node.real) || node.real <= 0.0)
    fail_input(fmt::format("{} is no positive number", what), node.where);
  return node.real;
}

/// A number, or two as a range.
PaperRatio read_ratio(const TomlNode& node) {
  if (node.type == TomlNode::Type::array && node.items.size() == 2) {
    const PaperRatio range{positive_number(node.items[0], "the paper's ratio"),
                           positive_number(node.items[1], "the paper's ratio")};
    if (range.low >= range.high)
      fail_input(fmt::format("the range from {} to {} is empty", range.low, range.high), node.where);
    return range;
  }
  const double ratio = positive_number(node, "the paper's ratio");
  if (ratio == 1.0)
    fail_input("a ratio of 1 says nothing about an order", node.where, "give a range such as [0.95, 1.05]");
  return {ratio, ratio};
}

void read_paper(TomlReader& reader, const std::vector<std::string>& scenes, Claim& claim) {
  if (reader.has("paper") == reader.has("at_least"))
    reader.fail("paper", "a claim needs either 'paper' or 'at_least'");
  if (reader.has("at_least")) {
    claim.every_scene = PaperRatio{positive_number(reader.require("at_least"), "'at_least'"),
                                   std::numeric_limits<double>::infinity()};
    return;
  }
  const TomlNode& paper = reader.require("paper");
  if (paper.type != TomlNode::Type::table) {
    claim.every_scene = read_ratio(paper);
    return;
  }
  for (const auto& [scene, node] : paper.entries) {
    if (std::ranges::find(scenes, scene) == scenes.end())
      fail_input(fmt::format("the claim speaks of '{}', which is not among the scenes", scene), node.where,
                 suggest_name(scene, scenes));
    claim.by_scene.emplace_back(scene, read_ratio(node));
  }
}

Claim read_claim(const TomlNode& table, const StudyFile& study) {
  TomlReader reader(table, "[[claim]]");
  std::vector<std::string> labels;
  for (const StudyRun& run : study.runs) labels.push_back(run.label);
  const auto label = [&](const std::string& key) {
    const std::string name = reader.text(key);
    if (std::ranges::find(labels, name) == labels.end())
      reader.fail(key, fmt::format("no run is labelled '{}'", name), suggest_name(name, labels));
    return name;
  };
  Claim claim;
  claim.where = table.where;
  claim.text = reader.text("text");
  claim.source = reader.text("source");
  claim.numerator = label("numerator");
  claim.denominator = label("denominator");
  if (claim.numerator == claim.denominator)
    reader.fail("denominator", "numerator and denominator are the same run");
  claim.quantity = static_cast<Quantity>(reader.choice("quantity", quantity_names()));
  const bool needs_pass = claim.quantity == Quantity::pass_time;
  if (needs_pass) claim.pass = reader.text("pass");
  const bool is_frame = claim.quantity == Quantity::time || claim.quantity == Quantity::fps;
  claim.without = reader.texts("without");
  if (!is_frame && !claim.without.empty())
    reader.fail("without", "'without' belongs to quantity = \"time\" or \"fps\"");
  if (!needs_pass && reader.has("pass")) reader.fail("pass", "'pass' belongs to quantity = \"pass_time\"");
  if (reader.has("pictures"))
    claim.pictures = static_cast<ClaimPictures>(reader.choice("pictures", kClaimPictures));
  if (!is_frame && !needs_pass && reader.has("unequal_cost"))
    reader.fail("unequal_cost", "'unequal_cost' is about times, not about memory");
  claim.has_unequal_cost = reader.boolean("unequal_cost", false);
  read_paper(reader, study.scenes, claim);
  reader.finish();
  return claim;
}

void require_unique(const std::vector<StudyRun>& runs) {
  std::vector<std::string> labels;
  for (const StudyRun& run : runs) {
    if (std::ranges::find(labels, run.label) != labels.end())
      fail_input(fmt::format("two runs are labelled '{}'", run.label), run.where, "labels must be unique");
    labels.push_back(run.label);
  }
}

void read_scenes(TomlReader& reader, StudyFile& study) {
  study.scenes = reader.texts("scenes");
  if (study.scenes.empty()) reader.fail("scenes", "the study has no scenes");
  require_different(reader, "scenes", "scene", study.scenes);
}

/// One or a list; none when absent.
std::vector<std::string> read_lights(TomlReader& reader) {
  const TomlNode* node = reader.find("light");
  if (node == nullptr) return {};
  if (node->type == TomlNode::Type::text) return {node->text};
  const std::vector<std::string> lights = reader.texts("light");
  if (lights.empty()) reader.fail("light", "'light' is an empty list");
  require_different(reader, "light", "light", lights);
  return lights;
}

double read_moment(const TomlNode& node) {
  const bool is_number = node.type == TomlNode::Type::integer || node.type == TomlNode::Type::real;
  if (!is_number || !std::isfinite(node.real))
    fail_input("a time is no number of seconds", node.where, "time = 0.5, or time = [0, 0.25, 0.5]");
  return node.real;
}

/// One or a list; none when absent.
void read_times(TomlReader& reader, StudyFile& study) {
  const TomlNode* node = reader.find("time");
  study.animation = reader.text("animation", "");
  if (node == nullptr) {
    if (!study.animation.empty()) reader.fail("animation", "'animation' goes with 'time', in seconds");
    return;
  }
  if (node->type != TomlNode::Type::array) {
    study.times_s = {read_moment(*node)};
    return;
  }
  if (node->items.empty()) reader.fail("time", "'time' is an empty list");
  for (const TomlNode& item : node->items) {
    const double time_s = read_moment(item);
    if (std::ranges::find(study.times_s, time_s) != study.times_s.end())
      fail_input(fmt::format("the time {} is given twice", time_s), item.where);
    study.times_s.push_back(time_s);
  }
}

/// One or a list.
std::vector<std::string> read_qualities(TomlReader& reader, const std::vector<std::string>& fallback) {
  const TomlNode* node = reader.find("quality");
  if (node == nullptr) return fallback;
  if (node->type == TomlNode::Type::text) return {node->text};
  const std::vector<std::string> qualities = reader.texts("quality");
  if (qualities.empty()) reader.fail("quality", "'quality' is an empty list");
  require_different(reader, "quality", "quality", qualities);
  if (qualities.size() == 1) return qualities;
  for (const char* own : {"width_px", "height_px", "samples_per_pixel", "target_se"}) {
    if (reader.has(own))
      reader.fail(own, fmt::format("'{}' goes with one quality, not with {}", own, qualities.size()));
  }
  return qualities;
}

void read_effort(TomlReader& reader, StudyFile& study) {
  study.qualities = read_qualities(reader, study.qualities);
  study.width_px = positive(reader, "width_px");
  study.height_px = positive(reader, "height_px");
  study.samples_per_pixel = positive(reader, "samples_per_pixel");
  if (reader.has("target_se")) study.target_se = reader.number("target_se");
  study.seeds = read_seeds(reader);
  const int64_t frames = reader.integer("frames", study.frames);
  if (frames < 1 || frames > kMaxFrames)
    reader.fail("frames", fmt::format("'frames' is {}, not in 1 to {}", frames, kMaxFrames));
  study.frames = static_cast<int>(frames);
  study.frame_budget_s = reader.number("frame_budget_s", study.frame_budget_s);
  if (study.frame_budget_s <= 0.0)
    reader.fail("frame_budget_s", fmt::format("'frame_budget_s' is {}, not positive", study.frame_budget_s));
}

}  // namespace

StudyFile read_study(const TomlNode& root) {
  TomlReader reader(root, "the study");
  const int64_t schema = reader.integer("schema");
  if (schema != kStudySchema)
    reader.fail("schema", fmt::format("schema {} is not known", schema),
                fmt::format("this reads {}", kStudySchema));
  StudyFile study;
  study.where = root.where;
  study.title = reader.text("title");
  study.doc = reader.text("doc", "");
  read_scenes(reader, study);
  read_times(reader, study);
  study.lights = read_lights(reader);
  study.cameras = read_study_cameras(reader);
  read_effort(reader, study);
  for (const TomlNode* table : reader.tables("run")) {
    for (StudyRun& run : expand_run(*table)) study.runs.push_back(std::move(run));
  }
  if (study.runs.empty()) fail_input("the study has no [[run]]", root.where);
  if (study.runs.size() > kMaxStudyRuns)
    fail_input(fmt::format("the study has {} runs, more than {}", study.runs.size(), kMaxStudyRuns),
               root.where);
  require_unique(study.runs);
  for (const TomlNode* table : reader.tables("claim")) study.claims.push_back(read_claim(*table, study));
  reader.finish();
  return study;
}

StudyFile parse_study(std::string_view document, const std::string& file) {
  return read_study(parse_toml(document, file));
}

StudyFile load_study(const std::filesystem::path& path) {
  return read_study(parse_toml_file(path));
}

}  // namespace umbrameter
