// SPDX-License-Identifier: Apache-2.0
// Mouse and fingers on a viewer's pictures: one moves the cursor, the picture or the slider; two zoom.

const kGrip_px = 14;  // this near to the slider's line one takes hold of it

function imagePoint(viewer, canvas, event) {
  const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
  const {scale, left, top} = placement(viewer, canvas);
  return {x: ((event.clientX - box.left) * ratio - left) / scale, y: ((event.clientY - box.top) * ratio - top) / scale};
}

function moveCursorTo(viewer, canvas, event) {
  const point = imagePoint(viewer, canvas, event);
  moveCursor(viewer, Math.floor(point.x) - viewer.cursor.x, Math.floor(point.y) - viewer.cursor.y);
}

function isOnDivider(viewer, canvas, event) {
  const box = canvas.getBoundingClientRect();
  return viewer.mode === "slider" && Math.abs(event.clientX - box.left - viewer.divider * box.width) < kGrip_px;
}

function pan(viewer, canvas, dx_px, dy_px) {
  const scale = placement(viewer, canvas).scale / (canvas.width / canvas.clientWidth);
  viewer.view.x -= dx_px / scale;
  viewer.view.y -= dy_px / scale;
  clampView(viewer);
  draw(viewer);
}

// Two fingers: zooms by how far they move apart, about the point between them.
function pinch(viewer, canvas, before, after) {
  const apart = ([a, b]) => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  const middle = ([a, b]) => ({clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2});
  const about = imagePoint(viewer, canvas, middle(after));
  if (apart(before) > 0) zoomAt(viewer, apart(after) / apart(before), about.x, about.y);
  pan(viewer, canvas, middle(after).clientX - middle(before).clientX, middle(after).clientY - middle(before).clientY);
}

function listenToCanvas(viewer, canvas) {
  const held = new Map();  // pointers that are down, by id
  let isSliding = false;
  const slide = event => {
    const box = canvas.getBoundingClientRect();
    setDivider(viewer, (event.clientX - box.left) / box.width);
  };
  canvas.addEventListener("pointerdown", event => {
    held.set(event.pointerId, event);
    isSliding = isOnDivider(viewer, canvas, event);
    viewer.root.focus({preventScroll: true});
    if (viewer.shown && held.size === 1 && !isSliding) moveCursorTo(viewer, canvas, event);
  });
  canvas.addEventListener("pointermove", event => {
    part(viewer, "readout").setAttribute("aria-live", "off");
    canvas.style.cursor = isOnDivider(viewer, canvas, event) ? "ew-resize" : "";
    if (!viewer.shown) return;
    const before = held.get(event.pointerId);
    if (!before) return moveCursorTo(viewer, canvas, event);
    const all = Array.from(held.values());
    held.set(event.pointerId, event);
    if (isSliding || viewer.view.zoom > 1 || held.size > 1) canvas.setPointerCapture(event.pointerId);
    if (isSliding) return slide(event);
    if (held.size === 2) return pinch(viewer, canvas, all, Array.from(held.values()));
    if (viewer.view.zoom > 1) return pan(viewer, canvas, event.clientX - before.clientX, event.clientY - before.clientY);
    moveCursorTo(viewer, canvas, event);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, event => {
      held.delete(event.pointerId);
      isSliding = false;
    });
  }
  canvas.addEventListener("wheel", event => {
    if (!viewer.root.contains(document.activeElement) && !event.ctrlKey) return;  // the page scrolls
    event.preventDefault();
    const point = imagePoint(viewer, canvas, event);
    zoomAt(viewer, event.deltaY < 0 ? 1.25 : 0.8, point.x, point.y);
  }, {passive: false});
}
