// SPDX-License-Identifier: Apache-2.0
#include "report/scene_section.h"

#include "core/html.h"
#include "report/facts.h"
#include "report/table.h"
#include "study/format.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

std::string folded(const std::string& attributes, const std::string& title, const std::string& content) {
  return fmt::format("<details {}><summary>{}</summary>{}</details>\n", attributes, escape_html(title),
                     content);
}

std::string run_details(const Results& results, const SceneResult& scene, const TechniqueResult& run,
                        const std::string& anchor) {
  std::string content = fmt::format("<p>{}</p>", escape_html(run.title));
  if (run.failure) content += fmt::format("<p class=\"problem\">{}</p>", escape_html(run.failure->message));
  if (!run.warnings.empty()) content += "<ul class=\"warnings\">" + list_items(run.warnings) + "</ul>";
  content += "<dl>" + run_facts(results, scene, run) + "</dl>";
  return folded(fmt::format("class=\"run\" id=\"{}\"", anchor), run.label, content);
}

std::vector<std::string> all_warnings(const SceneResult& scene) {
  std::vector<std::string> warnings = scene.warnings;
  if (scene.reference)
    warnings.insert(warnings.end(), scene.reference->warnings.begin(), scene.reference->warnings.end());
  return warnings;
}

}  // namespace

std::string scene_section(const Results& results, size_t scene_index) {
  const SceneResult& scene = results.scenes.at(scene_index);
  std::string html = fmt::format(
      "<section class=\"scene\" id=\"{}\"><h2>{}: {}</h2><p>{}</p><p class=\"context\">{} triangles; {} "
      "light '{}'; "
      "scene hash {}</p>\n",
      scene_anchor(scene_index), escape_html(scene.name), escape_html(scene.title), escape_html(scene.doc),
      scene.triangles, escape_html(scene.light_type), escape_html(scene.light_name), escape_html(scene.hash));
  if (scene.failure) html += fmt::format("<p class=\"problem\">{}</p>", escape_html(scene.failure->message));
  if (scene.parity) {
    html += fmt::format("<p class=\"{}\">Parity: {}</p>", scene.parity->passes ? "parity" : "problem",
                        escape_html(format_parity(*scene.parity)));
  }
  const std::vector<std::string> warnings = all_warnings(scene);
  if (!warnings.empty()) html += "<ul class=\"warnings\">" + list_items(warnings) + "</ul>";
  html += fmt::format("<div class=\"stage\" data-scene=\"{}\"></div>\n", scene_index);
  html += "<h3>Numbers</h3>\n";
  if (scene.reference)
    html += folded("class=\"facts\"", "Reference", "<dl>" + reference_facts(results, scene) + "</dl>");
  for (size_t i = 0; i < scene.techniques.size(); ++i) {
    html += run_details(results, scene, scene.techniques[i], run_anchor(scene_index, i));
  }
  return html + "</section>\n";
}

}  // namespace umbrameter
