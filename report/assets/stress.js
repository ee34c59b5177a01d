// SPDX-License-Identifier: Apache-2.0
// Stability maps: one stop for Tab each, arrows within, and what the cell under pointer or focus says.

function showCell(detail, cell) {
  detail.textContent = cell.dataset.detail;
}

function unfoldAxis(cell) {
  const axis = document.getElementById(cell.dataset.axis);
  axis.open = true;
  axis.scrollIntoView({block: "center"});
  axis.querySelector("summary").focus({preventScroll: true});
}

// The cell `right` columns and `down` rows from `cell`, the nearest that has something to say in that direction.
function nextCell(table, cell, right, down) {
  const rows = table.tBodies[0].rows;
  let x = cell.cellIndex, y = cell.parentElement.sectionRowIndex;
  for (;;) {
    x += right;
    y += down;
    const found = rows[y]?.cells[x];
    if (!found || found.tagName !== "TD") return null;
    if (found.dataset.detail) return found;
  }
}

function listenToMap(table) {
  const detail = table.closest(".table-scroll").nextElementSibling;
  const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  const first = table.querySelector("[data-detail]");
  if (first) first.tabIndex = 0;
  table.addEventListener("pointerover", event => {
    const cell = event.target.closest("[data-detail]");
    if (cell) showCell(detail, cell);
  });
  table.addEventListener("focusin", event => {
    const cell = event.target.closest("[data-detail]");
    if (!cell) return;
    for (const other of table.querySelectorAll("[tabindex='0']")) other.tabIndex = -1;
    cell.tabIndex = 0;
    showCell(detail, cell);
  });
  table.addEventListener("click", event => event.target.closest("[data-detail]") && unfoldAxis(event.target.closest("[data-detail]")));
  table.addEventListener("keydown", event => {
    const cell = event.target.closest("[data-detail]");
    if (!cell || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Enter") return unfoldAxis(cell);
    if (!steps[event.key]) return;
    event.preventDefault();
    nextCell(table, cell, ...steps[event.key])?.focus();
  });
}
