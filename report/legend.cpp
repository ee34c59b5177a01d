// SPDX-License-Identifier: Apache-2.0
#include "report/legend.h"

#include "core/html.h"
#include "report/plane_code.h"
#include "study/pictures.h"

#include <fmt/format.h>

#include <string_view>

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

}  // namespace

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

}  // namespace umbrameter
