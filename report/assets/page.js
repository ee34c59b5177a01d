// SPDX-License-Identifier: Apache-2.0
// Theme, links into the page, and viewers that are made when they come into sight.

let isDark = matchMedia("(prefers-color-scheme: dark)").matches;

function applyTheme() {
  const button = document.getElementById("theme");
  document.documentElement.dataset.theme = isDark ? "dark" : "light";
  button.textContent = isDark ? "Light" : "Dark";
  button.setAttribute("aria-pressed", String(isDark));
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

// #scene-2-run-3 shows that run, with its numbers unfolded.
function followLink() {
  const match = /^#scene-(\d+)-run-(\d+)$/.exec(location.hash);
  if (!match) return;
  const [scene, run] = [Number(match[1]) - 1, Number(match[2]) - 1];
  const numbers = document.getElementById(location.hash.slice(1));
  if (numbers) numbers.open = true;
  const viewer = makeViewer(scene);
  if (!viewer?.entry.runs[run]) return;
  show(viewer, run, viewer.otherIndex);
  viewer.root.scrollIntoView({block: "start"});
  viewer.root.focus({preventScroll: true});
}

function onPageKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input, select")) return;
  const actions = {t: toggleTheme, "?": () => document.getElementById("keys").showModal(), "/": () => document.getElementById("filter").focus()};
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
  for (const table of document.querySelectorAll("table.sortable")) listenToHeadings(table);
  listenToFilter(document.getElementById("results"));
  for (const table of document.querySelectorAll("table[role=grid]")) listenToMap(table);
  makeSweeps();
  makeBenches();
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
}

start();
