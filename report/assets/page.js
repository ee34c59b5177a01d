// SPDX-License-Identifier: Apache-2.0
// Theme, links into the page, and viewers that are made when they come into sight.

let isDark = matchMedia("(prefers-color-scheme: dark)").matches;

function applyTheme() {
  const button = document.getElementById("theme");
  document.documentElement.dataset.theme = isDark ? "dark" : "light";
  button.textContent = isDark ? "Light" : "Dark";
  button.setAttribute("aria-pressed", String(isDark));
  drawFront();
  for (const owner of sweepCharts) drawSweep(owner);
  for (const owner of benchCharts) {
    drawBench(owner);
    drawTruthCurve(owner);
  }
  for (const viewer of viewers.values()) {
    if (!viewer.shown) continue;
    draw(viewer);
    drawSceneCharts(viewer);
  }
}

function toggleTheme() {
  isDark = !isDark;
  applyTheme();
}

// The view as a link's end: scene, run, and what is chosen in the viewer.
function viewFragment(viewer) {
  const {view, cursor} = viewer;
  const state = new URLSearchParams({other: viewer.otherIndex, mode: viewer.mode, picture: viewer.picture, map: viewer.layer,
                                     scale: viewer.errorScale, zoom: view.zoom.toFixed(2), x: view.x.toFixed(1), y: view.y.toFixed(1),
                                     cursor: `${cursor.x},${cursor.y}`});
  return `#scene-${viewer.sceneIndex + 1}-run-${viewer.runIndex + 1}?${state}`;
}

function linkHere(viewer) {
  history.replaceState(null, "", viewFragment(viewer));
  navigator.clipboard?.writeText(location.href).catch(() => {});  // the address bar has it anyway
}

// What a link says of the view; anything it does not name or that is no number stays as it is.
function applyState(viewer, state) {
  const number = (name, fallback) => state.has(name) && Number.isFinite(Number(state.get(name))) ? Number(state.get(name)) : fallback;
  viewer.view = {zoom: number("zoom", viewer.view.zoom), x: number("x", viewer.view.x), y: number("y", viewer.view.y)};
  const cursor = (state.get("cursor") ?? "").split(",").map(Number);
  if (cursor.length === 2 && cursor.every(Number.isInteger)) viewer.cursor = {x: cursor[0], y: cursor[1]};
  if (layers[state.get("map")]) viewer.layer = state.get("map");
  if (number("scale", 0) > 0) setErrorScale(viewer, number("scale", viewer.errorScale));
  if (["lit", "visibility"].includes(state.get("picture")) && viewer.entry.planes.unshadowed) setPicture(viewer, state.get("picture"));
  if (kModes.includes(state.get("mode"))) setMode(viewer, state.get("mode"));
  if (viewer.cursor) viewer.cursor = {x: Math.min(Math.max(viewer.cursor.x, 0), viewer.entry.width - 1), y: Math.min(Math.max(viewer.cursor.y, 0), viewer.entry.height - 1)};
  clampView(viewer);
}

// #scene-2-run-3 shows that run, with its numbers unfolded; what follows a question mark is viewFragment's.
function followLink() {
  const match = /^#scene-(\d+)-run-(\d+)(?:\?(.*))?$/.exec(location.hash);
  if (!match) return;
  const [scene, run] = [Number(match[1]) - 1, Number(match[2]) - 1];
  const numbers = document.getElementById(`scene-${scene + 1}-run-${run + 1}`);
  if (numbers) numbers.open = true;
  const viewer = makeViewer(scene);
  if (!viewer?.entry.runs[run]) return;
  const state = new URLSearchParams(match[3] ?? ""), other = Number(state.get("other") ?? viewer.otherIndex);
  applyState(viewer, state);
  show(viewer, run, viewer.entry.runs[other] ? other : kReference);
  viewer.root.scrollIntoView({block: "start"});
  viewer.root.focus({preventScroll: true});
}

function focusFilter() {
  document.getElementById("all-runs").open = true;
  document.getElementById("filter").focus();
}

function onPageKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input, select")) return;
  const actions = {t: toggleTheme, "?": () => document.getElementById("keys").showModal(), "/": focusFilter};
  if (!actions[event.key]) return;
  event.preventDefault();
  actions[event.key]();
}

// A link to every part that is there.
function fillContents() {
  for (const section of document.querySelectorAll("main > section:not([hidden])")) {
    const link = document.createElement("a");
    link.href = "#" + section.id;
    link.textContent = section.querySelector("h2").textContent.replace(/:.*/, "");
    document.getElementById("contents").append(link);
  }
}

function start() {
  fillTexts();
  makeRegress();
  makeBenches();
  makeStress();
  makeSweeps();
  for (const table of document.querySelectorAll("table.sortable:not(#results)")) listenToHeadings(table);
  for (const table of document.querySelectorAll("table[role=grid]")) listenToMap(table);
  makeOverview();
  window.addEventListener("beforeprint", () => {
    fillAllRuns();
    for (const folded of document.querySelectorAll("#all-runs, .made")) folded.open = true;
  });
  fillContents();
  applyTheme();
  document.getElementById("theme").addEventListener("click", toggleTheme);
  document.getElementById("show-keys").addEventListener("click", () => document.getElementById("keys").showModal());
  document.addEventListener("keydown", onPageKey);
  const kAhead = "300px";
  const watcher = new IntersectionObserver(entries => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      watcher.unobserve(entry.target);
      makeViewer(Number(entry.target.dataset.scene));
    }
  }, {rootMargin: kAhead});
  for (const stage of document.querySelectorAll(".stage")) watcher.observe(stage);
  window.addEventListener("hashchange", followLink);
  followLink();
  performance.mark("numbers");  // bench/page.py
  fillOverview();
}

start();
