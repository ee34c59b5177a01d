// SPDX-License-Identifier: Apache-2.0
// A scene's section: what it is, the place of its viewer, and all numbers of its runs, made when they are unfolded.

function factList(lines) {
  return element("dl", {}, ...lines.map(([term, text]) => element("div", {}, element("dt", {}, term), element("dd", {}, text))));
}

// Folded; `content` gives what is inside, once, when it is first opened.
function foldedPart(attributes, title, content) {
  const folded = element("details", attributes, element("summary", {}, title));
  folded.addEventListener("toggle", () => { if (folded.open && folded.children.length === 1) folded.append(...content().filter(one => one)); });
  return folded;
}

function runPart(run, lines, common, id) {
  return foldedPart({class: "run", id}, run.label, () => [element("p", {}, run.title), run.failure ? element("p", {class: "problem"}, run.failure.message) : null,
                                                          warningList(run.warnings), factList([...lines, ...common])]);
}

// What a store's runs do not know of their scene is left out.
function sceneLine(scene) {
  const triangles = scene.triangles > 0 ? [`${scene.triangles} triangles`] : [];
  const light = `${scene.light.type} light${scene.light.name ? ` '${scene.light.name}'` : ""}`;
  return [...triangles, light, `scene hash ${scene.hash}`].join("; ");
}

function sceneSection(scene, index) {
  const texts = page.texts.scenes[index], anchor = `scene-${index + 1}`;
  const section = element("section", {class: "scene", id: anchor}, element("h2", {}, scene.title === scene.name ? scene.name : `${scene.name}: ${scene.title}`), element("p", {}, scene.doc),
                          element("p", {class: "context"}, sceneLine(scene)),
                          scene.failure ? element("p", {class: "problem"}, scene.failure.message) : null,
                          texts.parity ? element("p", {class: scene.parity.passes ? "context" : "problem"}, `Parity: ${texts.parity}`) : null,
                          warningList([...scene.warnings, ...scene.reference?.warnings ?? []]),
                          element("div", {class: "stage", "data-scene": index}), element("h3", {}, "Numbers"));
  if (texts.reference) section.append(foldedPart({class: "facts"}, "Reference", () => [factList([...texts.reference, ...texts.common])]));
  section.append(...scene.techniques.map((run, k) => runPart(run, texts.runs[k], texts.common, `${anchor}-run-${k + 1}`)));
  return section;
}
