#include "report/report.h"

#include "core/files.h"
#include "core/html.h"
#include "report/assets.h"
#include "report/facts.h"
#include "report/html.h"
#include "report/page_data.h"
#include "report/plane_code.h"
#include "report/scene_section.h"
#include "report/summary.h"
#include "report/table.h"
#include "study/pictures.h"
#include "study/results_json.h"

#include <fmt/format.h>

#include <limits>
#include <set>

namespace umbrameter {
namespace {

std::string css(const Rgb8& colour) {
  return fmt::format("rgb({},{},{})", colour[0], colour[1], colour[2]);
}

std::string swatch(const Rgb8& colour, std::string_view text) {
  return fmt::format("<li><span class=\"swatch\" style=\"background:{}\"></span>{}</li>", css(colour),
                     escape_html(text));
}

std::string quantisation() {
  return fmt::format(
      "<p>Pixels inside this page: V in steps of 1/{:.0f}, R of 1/{:.0f}, standard error and blocker "
      "distance as half "
      "floats (11 bits), positions in 65535 steps over their range. Read-outs, maps, profiles and z are of "
      "these; every other "
      "number is that of results.json.</p>",
      1.0 / kTestVisibilityCode.step, 1.0 / kReferenceVisibilityCode.step);
}

std::string legend() {
  const std::string ramp = fmt::format("linear-gradient(to right,{},{},{})", css(kTooDarkColour),
                                       css(kNoErrorColour), css(kTooBrightColour));
  std::string html = fmt::format(
      "<p>Visibility: grey, byte = 255 V; black sees nothing of the light, white all of it.</p>"
      "<p>Signed error V - R, the same scale everywhere; beyond it the colour is clipped and the share is "
      "stated:</p><div class=\"ramp\" style=\"background:{0}\" role=\"img\" aria-label=\"blue too dark, "
      "white no "
      "error, red too bright\"></div><div class=\"ramp-ends\"><span>-{1} too "
      "dark</span><span>0</span><span>+{1} "
      "too bright</span></div><ul class=\"swatches\">",
      ramp, kSignedErrorScale);
  html += swatch(kBackgroundColour, "nothing hit") + swatch(kUnscoredColour, "not scored");
  html += "</ul><p>Parity:</p><ul class=\"swatches\">";
  for (const ParityLegend& entry : parity_legend()) html += swatch(entry.colour, entry.text);
  html += "</ul><p>Faults:</p><ul class=\"swatches\">";
  for (const FaultLegend& entry : fault_legend()) html += swatch(entry.colour, entry.text);
  return html + "</ul>" + quantisation();
}

std::string skipped_list(const Results& results) {
  if (results.skipped.empty()) return "<p>Nothing was skipped.</p>";
  std::vector<std::string> texts;
  for (const Skip& skip : results.skipped) {
    texts.push_back(fmt::format("{}{}{}: {}", skip.scene, skip.technique.empty() ? "" : ", ", skip.technique,
                                skip.reason));
  }
  return "<ul>" + list_items(texts) + "</ul>";
}

std::string devices(const Results& results) {
  std::set<std::string> names;
  for (const SceneResult& scene : results.scenes) {
    if (scene.reference) names.insert(scene.reference->device);
    for (const TechniqueResult& run : scene.techniques) {
      if (run.device.empty()) continue;
      names.insert(run.timer.empty() ? run.device : run.device + ", timed by " + run.timer);
    }
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "; ") + name;
  return text;
}

std::string context(const Results& results) {
  const std::string target =
      results.target_se ? fmt::format(", until standard error {}", *results.target_se) : "";
  return fmt::format("umbrameter {} ({}); quality {}, {} x {} px, {} samples a pixel{}, seed {}; {}",
                     results.version, results.commit, results.quality, results.width_px, results.height_px,
                     results.samples_per_pixel, target, results.seed, devices(results));
}

/// Scripts in the order in which they need each other.
std::string scripts() {
  std::string text;
  for (const char* name : {"planes.js", "noise.js", "layers.js", "viewer.js", "viewer_draw.js",
                           "viewer_keys.js", "profile.js", "charts.js", "sweeps.js", "table.js", "page.js"}) {
    text += report_asset(name);
  }
  return text;
}

}  // namespace

std::string report_html(const Results& results, const std::filesystem::path& folder, PlaneStore& store) {
  const std::string data = page_data(results, folder, store);
  std::string scenes;
  for (size_t i = 0; i < results.scenes.size(); ++i) scenes += scene_section(results, i);
  return fill_template(report_asset("page.html"), {{"file_scripts", store.has_files() ? " file:" : ""},
                                                   {"style", std::string(report_asset("page.css"))},
                                                   {"chart", std::string(report_asset("chart.min.js"))},
                                                   {"script", scripts()},
                                                   {"context", escape_html(context(results))},
                                                   {"verdict", summary_verdicts(results)},
                                                   {"rows", summary_rows(results)},
                                                   {"legend", legend()},
                                                   {"skipped", skipped_list(results)},
                                                   {"data", data},
                                                   {"planes", store.blocks()},
                                                   {"scenes", scenes}});
}

std::string report_html(const Results& results, const std::filesystem::path& folder) {
  PlaneStore store({}, std::numeric_limits<size_t>::max());
  return report_html(results, folder, store);
}

void write_report(const std::filesystem::path& folder, const std::filesystem::path& html_file,
                  size_t budget_bytes) {
  const std::filesystem::path results_file = folder / "results.json";
  const Results results = parse_results(read_file(results_file), results_file.string());
  PlaneStore store(data_folder(html_file), budget_bytes);
  write_file_atomically(html_file, report_html(results, folder, store));
}

std::filesystem::path data_folder(const std::filesystem::path& html_file) {
  return html_file.parent_path() / (html_file.stem().string() + "-data");
}

}  // namespace umbrameter
