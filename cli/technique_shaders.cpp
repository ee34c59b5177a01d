// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/run_renderer.h"
#include "cli/shader_languages.h"
#include "cli/staging.h"
#include "cli/techniques_verbs.h"
#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Each text once.
std::vector<FinalShader> all_shaders(const TechniqueRun& run, const GlobalOptions& global, const Home& home) {
  const auto renderer = open_gl_renderer(global, home);
  std::vector<FinalShader> all;
  std::set<std::string> seen;
  for (const auto& [light, job] : scenes_by_light(scene_search(global, home))) {
    if (std::find(run.lights.begin(), run.lights.end(), light) == run.lights.end()) continue;
    const RenderRequest request{
        .width_px = 64, .height_px = 36, .technique = run.technique, .parameters = run.parameters};
    for (FinalShader& shader : final_shaders(*renderer, job.scene, request)) {
      if (seen.insert(shader.text).second) all.push_back(std::move(shader));
    }
  }
  return all;
}

/// "2-blur_x.frag.hlsl": in the order of passes, as names of passes may repeat.
std::string file_name(size_t index, const FinalShader& shader, ShaderLanguage language) {
  return fmt::format("{}-{}{}", index, shader.pass, file_ending(language, shader.stage));
}

}  // namespace

int show_shaders(const std::string& technique, const std::string& language_name,
                 const GlobalOptions& global) {
  const ShaderLanguage language = choose_shader_language(language_name);
  if (language == ShaderLanguage::spirv && global.out.empty())
    fail_input("SPIR-V is no text", {}, "give --out DIR");
  const Home home = find_home();
  const TechniqueRun run = choose_technique(technique, {}, home);
  std::vector<FinalShader> shaders = all_shaders(run, global, home);
  const Staging work(global.out.empty() ? std::filesystem::temp_directory_path()
                                        : std::filesystem::path(global.out));
  for (FinalShader& shader : shaders) shader.text = translate(shader, language, work.folder());
  OrderedJson list = OrderedJson::array();
  std::string answer;
  for (size_t k = 0; k < shaders.size(); ++k) {
    const FinalShader& shader = shaders[k];
    OrderedJson entry{{"pass", shader.pass}, {"stage", shader.stage}};
    if (global.out.empty()) {
      entry["text"] = shader.text;
      answer += fmt::format("// ---- pass {}, {} shader ----\n{}\n", shader.pass, shader.stage, shader.text);
    } else {
      const std::filesystem::path file = std::filesystem::path(global.out) / file_name(k, shader, language);
      write_file_atomically(file, shader.text);
      entry["file"] = file.string();
      print_note(fmt::format("wrote {}", file.string()));
    }
    list.push_back(entry);
  }
  if (global.json) {
    print_json({{"id", run.id}, {"language", language_name}, {"shaders", list}});
  } else if (!answer.empty()) {
    print_answer(answer);
  }
  return kExitFine;
}

}  // namespace umbrameter
