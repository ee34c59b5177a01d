// SPDX-License-Identifier: Apache-2.0
#include "cli/examples.h"

#include <fmt/format.h>

#include <map>

namespace umbrameter {
namespace {

using Examples = std::map<std::string, std::vector<std::string>>;

const Examples& all_examples() {
  static const Examples kExamples = {
      {"validate",
       {"validate plate --technique hard --technique pcss:filter_taps=64 --out out",
        "validate my-scene.toml --technique path/to/my-technique --quality quick"}},
      {"bench", {"bench my-study.toml --best-under 1ms", "bench studies/papers/paper-bc.toml --out truths"}},
      {"tune",
       {"tune plate --technique pcss --out tuned",
        "tune a.toml b.toml --technique pcf --parameters bias_texels,filter_width_texels"}},
      {"score",
       {"score mine.exr --reference truth.exr --report score.html",
        "score --shadowed lit.exr --unshadowed unlit.exr --scene plate --quantity visibility --limit 0.02"}},
      {"plan", {"plan my-study.toml --out results"}},
      {"sweep", {"sweep my-study.toml --out results", "sweep my-study.toml --shard 3/8 --out shards/3"}},
      {"merge", {"merge shards/1 shards/2 --out results"}},
      {"export", {"export results", "export results --csv --out runs.csv"}},
      {"report", {"report out", "report results --out page.html"}},
      {"reference", {"reference plate --out truth.exr", "reference plate --exact-check 300"}},
      {"render", {"render plate --technique vsm --out mine.exr"}},
      {"view", {"view plate --technique pcss"}},
      {"techniques", {"techniques"}},
      {"techniques list", {"techniques list --json"}},
      {"techniques show", {"techniques show pcss"}},
      {"techniques traits", {"techniques traits hard pcss"}},
      {"techniques doc", {"techniques doc out/results.json --out techniques.md"}},
      {"techniques check", {"techniques check path/to/my-technique"}},
      {"techniques glsl",
       {"techniques glsl pcss:filter_taps=64", "techniques glsl pcss --language hlsl --out shaders"}},
      {"engines", {"engines"}},
      {"engines list", {"engines list --json"}},
      {"engines show", {"engines show three"}},
      {"engines check", {"engines check three"}},
      {"scene", {"scene list", "scene check my-scene.toml"}},
      {"scene list", {"scene list --json"}},
      {"scene check", {"scene check plate my-scene.toml"}},
      {"scene plan", {"scene plan plate --quality full"}},
      {"scene import", {"scene import model.glb --out my-scene.toml"}},
      {"scene show", {"scene show my-scene.toml --out seen.png"}},
      {"scene export", {"scene export plate --width 960 --height 540 --out plate"}},
      {"selftest", {"selftest", "selftest --only acne"}},
      {"regress", {"regress check suites/small.toml --baseline baselines"}},
      {"regress record", {"regress record suites/small.toml --baseline baselines"}},
      {"regress check",
       {"regress check suites/small.toml --baseline baselines --junit checks.xml",
        "regress check suites/small.toml --baseline baselines --update --reason \"wider filter, looked at "
        "it\""}},
      {"regress prove", {"regress prove --scene plate"}},
      {"stress", {"stress --technique pcss --out map"}},
      {"metrics", {"metrics"}},
      {"doctor", {"doctor"}},
      {"help", {"help validate", "help scene check"}}};
  return kExamples;
}

std::string with_examples(const std::string& path, const std::string& footer) {
  const std::vector<std::string> examples = examples_of(path);
  if (examples.empty()) return footer;
  std::string text = examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& example : examples) text += fmt::format("  {}\n", example);
  return text + "\n" + footer;
}

void add_below(CLI::App& app, const std::string& path) {
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) {
    const std::string name = path.empty() ? verb->get_name() : path + " " + verb->get_name();
    add_below(*verb, name);
    verb->footer(with_examples(name, verb->get_footer()));
  }
}

}  // namespace

std::vector<std::string> examples_of(const std::string& verb_path) {
  const auto found = all_examples().find(verb_path);
  if (found == all_examples().end()) return {};
  std::vector<std::string> lines;
  for (const std::string& example : found->second) lines.push_back("umbrameter " + example);
  return lines;
}

void add_examples(CLI::App& app) {
  add_below(app, "");
}

}  // namespace umbrameter
