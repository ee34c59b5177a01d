// SPDX-License-Identifier: Apache-2.0
// Keys and controls of a viewer; pointers are viewer_pointer.js.

const kMaxZoom = 64;

function clampView(viewer) {
  const {view, entry} = viewer;
  view.zoom = Math.min(Math.max(view.zoom, 1), kMaxZoom);
  const halfWidth = entry.width / 2 / view.zoom, halfHeight = entry.height / 2 / view.zoom;
  view.x = Math.min(Math.max(view.x, halfWidth), entry.width - halfWidth);
  view.y = Math.min(Math.max(view.y, halfHeight), entry.height - halfHeight);
}

// Zooms about an image point, which stays where it is.
function zoomAt(viewer, factor, x, y) {
  const before = viewer.view.zoom;
  viewer.view.zoom = Math.min(Math.max(before * factor, 1), kMaxZoom);
  const share = before / viewer.view.zoom;
  viewer.view.x = x + (viewer.view.x - x) * share;
  viewer.view.y = y + (viewer.view.y - y) * share;
  clampView(viewer);
  draw(viewer);
}

function zoomAtCursor(viewer, factor) {
  zoomAt(viewer, factor, viewer.cursor.x + 0.5, viewer.cursor.y + 0.5);
}

function fit(viewer) {
  viewer.view.zoom = 1;
  clampView(viewer);
  draw(viewer);
}

function moveCursor(viewer, dx, dy) {
  const {cursor, entry, view} = viewer;
  cursor.x = Math.min(Math.max(cursor.x + dx, 0), entry.width - 1);
  cursor.y = Math.min(Math.max(cursor.y + dy, 0), entry.height - 1);
  const reachX = entry.width / 2 / view.zoom - 1, reachY = entry.height / 2 / view.zoom - 1;
  view.x = Math.min(Math.max(view.x, cursor.x + 0.5 - reachX), cursor.x + 0.5 + reachX);  // keep it in sight
  view.y = Math.min(Math.max(view.y, cursor.y + 0.5 - reachY), cursor.y + 0.5 + reachY);
  clampView(viewer);
  draw(viewer);
}

function setDivider(viewer, share) {
  viewer.divider = Math.min(Math.max(share, 0), 1);
  part(viewer, "divider").value = String(Math.round(100 * viewer.divider));
  draw(viewer);
}

function flip(viewer) {
  viewer.isFlipped = !viewer.isFlipped;
  if (viewer.mode === "flip") draw(viewer);
  else setMode(viewer, "flip");
}

function cycleLayer(viewer) {
  const select = part(viewer, "layer");
  select.selectedIndex = (select.selectedIndex + 1) % select.options.length;
  select.dispatchEvent(new Event("change"));
}

function setPicture(viewer, picture) {
  viewer.picture = picture;
  part(viewer, "picture").value = picture;
  part(viewer, "exposure").disabled = picture !== "lit";
  viewer.bitmaps.other = viewer.bitmaps.run = null;
  draw(viewer);
}

function setErrorScale(viewer, scale) {
  viewer.errorScale = scale;
  part(viewer, "error-scale").value = String(scale);
  if (viewer.shown) viewer.shown.errorScale = scale;
  viewer.bitmaps.map = null;
  draw(viewer);
}

// Key -> what it does; listed for people in page.html.
const viewerKeys = {
  ArrowLeft: (viewer, far) => moveCursor(viewer, -far, 0),
  ArrowRight: (viewer, far) => moveCursor(viewer, far, 0),
  ArrowUp: (viewer, far) => moveCursor(viewer, 0, -far),
  ArrowDown: (viewer, far) => moveCursor(viewer, 0, far),
  "+": viewer => zoomAtCursor(viewer, 2),
  "=": viewer => zoomAtCursor(viewer, 2),
  "-": viewer => zoomAtCursor(viewer, 0.5),
  0: fit,
  1: viewer => setMode(viewer, "panes"),
  2: viewer => setMode(viewer, "flip"),
  3: viewer => setMode(viewer, "slider"),
  4: viewer => setMode(viewer, "difference"),
  " ": flip,
  "[": viewer => setDivider(viewer, viewer.divider - 0.05),
  "]": viewer => setDivider(viewer, viewer.divider + 0.05),
  v: viewer => { if (viewer.entry.planes.unshadowed) setPicture(viewer, viewer.picture === "lit" ? "visibility" : "lit"); },
  n: viewer => step(viewer, 1),
  p: viewer => step(viewer, -1),
  m: cycleLayer,
  s: viewer => savePicture(viewer),
};

function onKey(viewer, event) {
  const isControl = event.target.closest("select, input, button");
  if (event.ctrlKey || event.metaKey || event.altKey || isControl) return;
  const action = viewerKeys[event.key];
  if (!action || !viewer.shown) return;
  event.preventDefault();
  part(viewer, "readout").setAttribute("aria-live", "polite");  // a mouse would make it chatter
  action(viewer, event.shiftKey ? 10 : 1);
}

function listen(viewer) {
  const {root} = viewer;
  root.addEventListener("keydown", event => onKey(viewer, event));
  for (const canvas of root.querySelectorAll("[data-pane] canvas")) listenToCanvas(viewer, canvas);
  for (const button of root.querySelectorAll("[data-mode]")) {
    button.addEventListener("click", () => setMode(viewer, button.dataset.mode));
  }
  const onClick = {"zoom-in": () => zoomAtCursor(viewer, 2), "zoom-out": () => zoomAtCursor(viewer, 0.5),
                   fit: () => fit(viewer), flip: () => flip(viewer), save: () => savePicture(viewer), link: () => linkHere(viewer),
                   "figure-png": () => saveFigure(viewer, "png"), "figure-svg": () => saveFigure(viewer, "svg")};
  for (const [role, action] of Object.entries(onClick)) part(viewer, role).addEventListener("click", action);
  part(viewer, "run").addEventListener("change", event => show(viewer, Number(event.target.value), viewer.otherIndex));
  part(viewer, "other").addEventListener("change", event => show(viewer, viewer.runIndex, Number(event.target.value)));
  part(viewer, "divider").addEventListener("input", event => setDivider(viewer, event.target.value / 100));
  part(viewer, "picture").addEventListener("change", event => setPicture(viewer, event.target.value));
  part(viewer, "exposure").addEventListener("input", event => {
    viewer.exposure_stops = Number(event.target.value);
    setPicture(viewer, viewer.picture);
  });
  part(viewer, "error-scale").addEventListener("change", event => setErrorScale(viewer, Number(event.target.value)));
  part(viewer, "layer").addEventListener("change", event => {
    viewer.layer = event.target.value;
    viewer.bitmaps.map = null;
    draw(viewer);
  });
  new ResizeObserver(() => draw(viewer)).observe(part(viewer, "panes"));
}
